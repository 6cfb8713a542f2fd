/** Queue that sends one value at a time; of the pending ones only the last is sent. */
export class SetQueue<Value> {
  private isBusy = false;
  private due: {value: Value} | undefined;

  constructor(private readonly send: (value: Value) => Promise<void>) {}

  async put(value: Value): Promise<void> {
    this.due = {value};
    if (this.isBusy) return;
    this.isBusy = true;
    while (this.due) {
      const {value: next}: {value: Value} = this.due;
      this.due = undefined;
      await this.send(next);
    }
    this.isBusy = false;
  }
}
