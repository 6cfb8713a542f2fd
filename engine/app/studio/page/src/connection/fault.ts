/** Fault of a diagram in the format of `check --json`. Lines and columns count from 1; `end` is behind the last character. */
export interface DiagramFault {
  file: string;
  line: number;
  column: number;
  end?: {line: number; column: number};
  subject?: string;
  text: string;
  cure?: string;
}

/** Reason of a failed call for the user: the problem and its cure. */
export class Fault extends Error {
  constructor(readonly text: string, readonly cure?: string, readonly faults: DiagramFault[] = [], readonly detail: Record<string, unknown> = {}) {
    super(cure ? `${text}; ${cure}` : text);
    this.name = "Fault";
  }

  /** Converts the fault of an answer, or any other thrown value. */
  static from(thrown: unknown): Fault {
    if (thrown instanceof Fault) return thrown;
    if (typeof thrown !== "object" || thrown === null) return new Fault(String(thrown));
    const {text, message, cure, faults, ...detail} = thrown as Record<string, unknown>;
    return new Fault(String(text ?? message ?? "the call failed"), cure === undefined ? undefined : String(cure),
      Array.isArray(faults) ? (faults as DiagramFault[]) : [], detail);
  }
}
