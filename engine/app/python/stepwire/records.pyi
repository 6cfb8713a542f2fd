"""Records of results, printed by 'stepwire format --python'."""

from typing import Any, ClassVar, Mapping, Optional, TypeVar

_R = TypeVar("_R", bound="Record")

class Record:
    """Named values of a result. A missing number is nan, a missing text empty."""
    field_units: ClassVar[dict[str, str]]
    """the unit of each field that has one"""
    field_docs: ClassVar[dict[str, str]]
    """the meaning of each field"""
    @classmethod
    def read(cls: type[_R], data: Mapping[str, Any]) -> _R:
        """The record of an object of the JSON file."""
    def to_dict(self) -> dict[str, Any]:
        """The fields by name, those of inner records, too."""

class RunParameter(Record):
    """A parameter of the file."""
    name: str
    """name"""
    value: Any
    """number in SI, or text"""
    unit: str
    """SI unit; null if unknown"""
    written: str
    """value as written or set"""
    assumed: bool
    """true if the file marks it as assumed"""
    set: bool
    """true if the call sets it"""

class SweepAxis(Record):
    """An axis of a sweep."""
    parameter: str
    """swept parameter"""
    count: int
    """number of values"""
    values: list[str]
    """values; empty for more than 10,000, which sweep.csv has"""

class Lanes(Record):
    """Runs that were stepped together."""
    count: int
    """number of lanes"""
    ticks: int
    """ticks in lanes"""
    why_not: str
    """reason for runs without lanes"""

class AlgebraicLoop(Record):
    """Cost of an algebraic loop."""
    loop: str
    """blocks of the loop"""
    unknowns: int
    """numbers at which the loop is torn"""
    instants: int
    """ticks and stages at which it was solved"""
    iterations: int
    """passes through its blocks"""
    max_iterations: int
    """largest number of passes at an instant"""
    unsolved: int
    """instants without a solution"""
    first_unsolved: float
    """time of the first of them [s]"""

class SolverSteps(Record):
    """Steps of a solver with error control."""
    relative: float
    """relative tolerance"""
    absolute: float
    """absolute tolerance [SI]"""
    accepted: int
    """accepted steps"""
    rejected: int
    """rejected steps"""
    largest_error: float
    """of the accepted steps, relative to the tolerance"""
    stiff: Optional[bool]
    """true if 'auto' has switched to the stiff method; null for another solver"""

class LocatedEvents(Record):
    """Events that were located between ticks."""
    located: int
    """number of events"""
    most_in_a_step: int
    """largest number in a step"""

class Notice(Record):
    """A sentence that a block raised during the run."""
    block: str
    """block"""
    time: float
    """first time [s]"""
    text: str
    """sentence"""

class RunResult(Record):
    """The result of a run or a sweep: run.json."""
    file: str
    """diagram file"""
    title: str
    """title"""
    hash: str
    """hash of the diagram and its data"""
    parameters: list[RunParameter]
    """parameters of the file"""
    step: float
    """step [s]"""
    stop: float
    """end [s]"""
    solver: str
    """solver; null if the file names none"""
    sweep: list[SweepAxis]
    """axes of the sweep; null for a single run"""
    keep: str
    """kind of data that a sweep keeps: rows, final or numbers"""
    kept: dict[str, str]
    """expressions of the kept numbers; null without"""
    recorded_runs: list[int]
    """runs whose rows are kept beside the numbers, from 1"""
    runs: int
    """number of runs"""
    ticks: int
    """ticks of all runs"""
    compiled_ticks: int
    """ticks in compiled code"""
    lanes: Optional[Lanes]
    """runs that were stepped together; null for a single run"""
    blocks: int
    """number of blocks"""
    block_folders: list[str]
    """folders of external blocks"""
    algebraic_loops: list[AlgebraicLoop]
    """costs of algebraic loops"""
    solver_steps: Optional[SolverSteps]
    """steps of the solver; null without error control"""
    events: Optional[LocatedEvents]
    """located events; null without event location"""
    notices: list[Notice]
    """sentences that blocks raised"""
    findings: list[str]
    """sentences on the figures"""
    faults: list[str]
    """faults that ended runs early"""
    interrupted: bool
    """true if it was interrupted"""
    version: str
    """version of the program"""
    compiler: str
    """compiler of the program"""
    duration: float
    """duration of the run [s]"""

class LoopDiagram(Record):
    """Diagram of the loop."""
    file: str
    """file"""
    title: str
    """title"""
    hash: str
    """hash"""
    blocks: int
    """number of blocks"""
    states: int
    """number of states"""
    step_s: float
    """step [s]"""
    engine: str
    """engine"""

class Deadlines(Record):
    """Counts of deadlines."""
    planned: int
    """planned deadlines"""
    passed: int
    """deadlines that have passed"""
    missed: int
    """late and dropped ones"""
    late: int
    """late ones"""
    dropped: int
    """dropped ones"""
    longest_row: int
    """longest row of missed ones"""

class LoopTimes(Record):
    """Distribution of measured times."""
    count: int
    """number of times"""
    min: int
    """shortest [ns]"""
    mean: float
    """mean [ns]"""
    p50: int
    """median [ns]"""
    p99: int
    """not exceeded by 99 % [ns]"""
    p99_9: int
    """not exceeded by 99.9 % [ns]"""
    max: int
    """longest [ns]"""
    histogram: list[list[int]]
    """begin [ns] and count of each bin that is not empty"""

class LoopWorst(Record):
    """Longest times in equal intervals of the run."""
    stretch_s: float
    """length of an interval [s]"""
    wake_up: list[int]
    """longest delay of a wake-up [ns]"""
    response: list[int]
    """longest response [ns]"""
    step: list[int]
    """longest step [ns]"""

class TypeCost(Record):
    """Cost of the blocks of a type."""
    type: str
    """type"""
    blocks: int
    """number of blocks"""
    mean: float
    """mean time of a tick; null without samples [ns]"""
    samples: int
    """number of samples"""

class TypeCosts(Record):
    """Sampled cost of the block types."""
    how: str
    """method"""
    types: list[TypeCost]
    """types"""

class LoopThread(Record):
    """Thread of the loop."""
    policy: str
    """effective policy"""
    cpu: Optional[int]
    """processor; null if the thread is not bound"""
    spin: int
    """time awake before a deadline [ns]"""
    refused: list[str]
    """requests that the system refused"""
    minor_faults: int
    """pages that were mapped"""
    major_faults: int
    """pages that were read from a disk"""
    allocations: Optional[int]
    """memory requests; null if not counted"""
    voluntary_switches: int
    """switches while the thread waited"""
    involuntary_switches: int
    """switches to another thread"""

class LoopRows(Record):
    """Recorded rows."""
    written: int
    """written rows"""
    lost_to_ring: int
    """rows that a slow writer lost"""
    lost_to_disk: int
    """rows that the disk refused"""

class Cyclictest(Record):
    """Wake-ups by cyclictest at the rate and policy of the loop."""
    command: str
    """command"""
    count: int
    """number of wake-ups"""
    p50_us: int
    """median [us]"""
    p99_us: int
    """not exceeded by 99 % [us]"""
    p99_9_us: int
    """not exceeded by 99.9 % [us]"""
    max_us: int
    """longest [us]"""

class Machine(Record):
    """Machine of the loop. Unknown texts are null."""
    processor: str
    """processor"""
    processors: int
    """number of processors"""
    virtual: bool
    """true for a virtual machine"""
    kernel: str
    """kernel"""
    kernel_command_line: str
    """boot command line"""
    governor: str
    """frequency governor"""
    clock_source: str
    """clock source"""
    isolated: str
    """processors that the scheduler does not use"""

class LoopResult(Record):
    """The result of a real-time loop: loop.json."""
    diagram: LoopDiagram
    """diagram"""
    end: str
    """reason of the end"""
    faults: list[str]
    """fault that ended the loop"""
    rate_hz: float
    """wake-ups in a second [Hz]"""
    duration_s: float
    """planned duration [s]"""
    steps: int
    """steps"""
    ticks: int
    """ticks"""
    deadlines: Deadlines
    """deadlines"""
    algebraic_loops: list[AlgebraicLoop]
    """costs of algebraic loops"""
    resolution: float
    """width of a bin as a share of its times"""
    wake_up: LoopTimes
    """delay of the wake-ups"""
    response: LoopTimes
    """time until outputs are written"""
    step: LoopTimes
    """time of a step"""
    worst: LoopWorst
    """longest times over the run"""
    block_types: TypeCosts
    """cost of the block types"""
    thread: LoopThread
    """thread"""
    rows: Optional[LoopRows]
    """recorded rows; null if none are recorded"""
    cyclictest: Optional[Cyclictest]
    """measurement beside the loop; null without --baseline"""
    machine: Machine
    """machine"""
    version: str
    """version of the program"""
    compiler: str
    """compiler of the program"""

class StudyTrial(Record):
    """A scored trial. Units of errors are those of the study's task."""
    subject: str
    """person"""
    condition: str
    """condition"""
    error: float
    """error of the path"""
    normalised: float
    """error over the largest one"""
    raw: float
    """error before resampling"""
    deviation: float
    """error that does not depend on sampling and length"""
    length: float
    """length of the scored path [m]"""
    duration: float
    """duration of the scored path [s]"""
    points: int
    """number of scored points"""
    order: Optional[int]
    """number among the person's trials, from 1"""
    attempts: Optional[int]
    """number of attempts"""
    sets: dict[str, str]
    """settings of the run"""

class StudyAnalysis(Record):
    """Analysis of the errors of a study."""
    means: dict[str, float]
    """mean normalised error of each condition"""
    anova: Any
    """analysis of variance over the factors of the conditions"""
    anova_with_subject: Any
    """the same with the subject as a factor"""
    repeated_measures: Any
    """repeated measures over the factors, or the reason why there are none"""
    within_subjects: Any
    """comparisons of conditions, or the reason why there are none"""
    side_by_side: list[Any]
    """published values beside ours"""

class StudyPoint(Record):
    """Experiment at a point of the file's sweep."""
    sets: dict[str, str]
    """swept values"""
    trials_file: str
    """file of its trials"""
    rule: str
    """rule of scoring"""
    remarks: list[str]
    """trials that were repeated, left out or too long"""
    trials: list[StudyTrial]
    """trials"""
    seed: Optional[int]
    """seed of the experiment; missing for recorded trials"""
    orders: dict[str, list[str]]
    """order of the conditions of each person; missing for recorded trials"""
    experiments: list[Any]
    """seed and values of each experiment; missing for a single one"""
    analysis: Optional[StudyAnalysis]
    """analysis of the errors; missing if they cannot be analysed"""

class StudyResult(Record):
    """The result of a study: study.json."""
    file: str
    """diagram file"""
    task: str
    """task"""
    trials_of: str
    """file of the recorded trials, or simulated operators"""
    rule: str
    """rule of scoring"""
    remarks: list[str]
    """trials that were repeated, left out or too long"""
    trials: list[StudyTrial]
    """trials"""
    seed: Optional[int]
    """seed of the experiment; missing for recorded trials"""
    orders: dict[str, list[str]]
    """order of the conditions of each person; missing for recorded trials"""
    experiments: list[Any]
    """seed and values of each experiment; missing for a single one"""
    analysis: Optional[StudyAnalysis]
    """analysis of the errors; missing if they cannot be analysed"""
    points: list[StudyPoint]
    """points of the file's sweep, in the place of the fields of one experiment"""

class Claim(Record):
    """A claim of the file, judged: an entry of claims.json."""
    file: str
    """diagram file"""
    figure: Optional[int]
    """figure of a publication that the file reproduces; null without"""
    that: str
    """statement"""
    check: str
    """condition"""
    value: float
    """value; null if it could not be judged [SI]"""
    holds: bool
    """true if it holds"""
    invariant: bool
    """true for an invariant"""
    disagrees: str
    """reason in the file for a known failure"""
    interval: Optional[tuple[float, float]]
    """confidence interval of a reduction over several runs [SI]"""
    confidence: float
    """confidence of the interval"""
    worst: str
    """settings of the run that gave the value"""
    note: str
    """reason why it could not be judged"""
    shown: str
    """value with its unit"""
    fails: bool
    """true if it fails and the file does not expect that"""

class PhaseCost(Record):
    """Calls of a block in a phase of the run."""
    calls: int
    """number of calls"""
    seconds: float
    """their time [s]"""

class BlockCost(Record):
    """Cost of a block, or of all blocks in a part."""
    name: str
    """name of the block or the part"""
    type: str
    """type of the block, or part"""
    calls: int
    """number of calls"""
    self: float
    """time of the block itself; 0 for a part [s]"""
    total: float
    """time of all calls [s]"""
    phases: dict[str, PhaseCost]
    """calls in the phases timed, outputs, stages, derivatives and updates"""

class OtherCost(Record):
    """Cost of the run outside of blocks."""
    name: str
    """work of the run"""
    calls: int
    """number of calls"""
    seconds: float
    """their time [s]"""

class Profile(Record):
    """Distribution of the time of a run: run --profile."""
    ticks: int
    """ticks of the run"""
    seconds: float
    """time of all steps [s]"""
    blocks: list[BlockCost]
    """blocks and parts, the most expensive first"""
    others: list[OtherCost]
    """costs outside of blocks"""
    algebraic_loops: list[AlgebraicLoop]
    """costs of algebraic loops, whose repeated calls are not counted above"""
    left: float
    """time in none of the other numbers [s]"""

class FittedParameter(Record):
    """A number that a fit found, in SI."""
    name: str
    """name of the parameter"""
    record: str
    """record with this value; missing if all records share it"""
    value: float
    """value [SI]"""
    unit: str
    """SI unit; null if unknown"""
    start: float
    """value at the start [SI]"""
    standard_error: float
    """error of the interval; null if undetermined [SI]"""
    standard_error_classical: float
    """error for independent rows [SI]"""
    standard_error_serial: float
    """error for correlated rows of a time series [SI]"""
    interval: tuple[float, float]
    """95 % interval [SI]"""
    at_bound: bool
    """true at a bound of the file"""

class FittedRecord(Record):
    """Agreement of the model with a record."""
    record: str
    """label of the record"""
    held_out: bool
    """true if the fit does not use it"""
    rows: int
    """number of compared rows"""
    fit: list[float]
    """agreement of each comparison; null for a constant record [%]"""

class FittedCurve(Record):
    """A function of the fitted parameters with its 95 % interval, in SI."""
    curve: str
    """label of the function"""
    unit: str
    """SI unit of the function; null if unknown"""
    at: list[float]
    """values of the variable [SI]"""
    value: list[float]
    """values of the function [SI]"""
    low: list[float]
    """lower ends of the interval [SI]"""
    high: list[float]
    """upper ends of the interval [SI]"""
    data_range: list[float]
    """range of the variable in the records; empty if unknown [SI]"""

class FittedStart(Record):
    """Result of the search from one start."""
    cost: float
    """final cost; null if nothing could be evaluated"""
    finished: bool
    """false if others were ahead and it was given up"""
    iterations: int
    """number of iterations"""

class FitResult(Record):
    """The result of a fit: fit.json."""
    file: str
    """diagram file"""
    parameters: list[FittedParameter]
    """fitted numbers"""
    correlation: list[list[float]]
    """correlation of the fitted numbers"""
    cost: float
    """half of the sum of squares of the residuals after the loss"""
    deviation: float
    """standard deviation of a weighted residual"""
    degrees_of_freedom: float
    """rows minus fitted numbers"""
    standard_errors: str
    """kind of the standard errors of the intervals"""
    rows_in_time: bool
    """true if the rows are a time series"""
    residuals_together: int
    """number of consecutive rows over which residuals are correlated"""
    records: list[FittedRecord]
    """agreement with each record"""
    curves: list[FittedCurve]
    """functions of the fitted parameters"""
    starts: list[FittedStart]
    """searches"""
    findings: list[str]
    """undetermined parameters, bounds, refused values"""
    converged: bool
    """true at a minimum"""
    limited: bool
    """true if the diagram refuses values of a lower cost"""
    interrupted: bool
    """true if it was interrupted"""
    compiled: bool
    """true if one compilation served all runs"""
    in_part: bool
    """true if only the blocks that the parameters affect ran"""
    duration: float
    """duration of the fit [s]"""

class TunedParameter(Record):
    """A number that an optimisation found, in SI."""
    name: str
    """name of the parameter"""
    value: float
    """value [SI]"""
    unit: str
    """SI unit; null if unknown"""
    start: float
    """value at the start [SI]"""
    bounds: tuple[float, float]
    """bounds [SI]"""
    interval: Optional[tuple[float, float]]
    """95 % interval; null in a free direction and without targets [SI]"""
    at_bound: bool
    """true at a bound"""

class TunedTarget(Record):
    """A target at the optimum."""
    that: str
    """statement"""
    check: str
    """condition"""
    value: float
    """value at the optimum [SI]"""
    off: float
    """error in units of its deviation"""
    start: float
    """the same at the start"""
    derivatives: list[float]
    """derivatives by the parameters, in deviations per range from bound to bound"""

class TunedClaim(Record):
    """A claim at the optimum."""
    that: str
    """statement"""
    check: str
    """condition"""
    value: float
    """value at the optimum [SI]"""
    shown: str
    """value with its unit"""
    start: float
    """value at the start [SI]"""
    margin: float
    """margin at the optimum; negative if the claim fails [SI]"""
    holds: bool
    """true if it holds"""
    active: bool
    """true if the claim limits the objective"""

class TunedStart(Record):
    """Result of the search from one start."""
    objective: float
    """objective; null if no point satisfies all claims [SI]"""
    converged: bool
    """true if the search converged"""
    evaluations: int
    """number of evaluations"""

class TuneResult(Record):
    """The result of an optimisation: tune.json."""
    file: str
    """diagram file"""
    minimise: str
    """expression of the objective"""
    parameters: list[TunedParameter]
    """optimised numbers"""
    objective: float
    """objective at the optimum [SI]"""
    unit: str
    """SI unit of the objective; null if unknown"""
    start_objective: float
    """objective at the start [SI]"""
    worst: str
    """run with the largest objective; null for a single run"""
    targets: list[TunedTarget]
    """targets in the order of the file"""
    singular_values: list[float]
    """singular values of the derivatives of the targets; below 1 a direction is free"""
    claims: list[TunedClaim]
    """claims of the section"""
    starts: list[TunedStart]
    """searches"""
    findings: list[str]
    """bounds, violated claims, failed evaluations"""
    method: str
    """method of the search"""
    evaluations: int
    """number of evaluations"""
    failed_evaluations: int
    """number of evaluations without an objective"""
    runs: int
    """number of runs per evaluation"""
    feasible: bool
    """true if all claims hold"""
    converged: bool
    """true if the search converged"""
    interrupted: bool
    """true if it was interrupted"""
    compiled: bool
    """true if runs were compiled"""
    duration: float
    """duration of the optimisation [s]"""

class InnerDelay(Record):
    """A delay from an additional output to an additional input of the system."""
    time: float
    """delay [s]"""
    output: str
    """output into the delay"""
    input: str
    """input out of the delay"""

class ChannelUnits(Record):
    """SI units of states, inputs and outputs."""
    states: list[str]
    """of the states"""
    inputs: list[str]
    """of the inputs"""
    outputs: list[str]
    """of the outputs"""

class Mode(Record):
    """A pole with its frequency and damping."""
    pole: complex
    """pole [rad/s]"""
    natural_frequency: float
    """natural frequency [rad/s]"""
    damping: float
    """damping ratio"""

class Rank(Record):
    """Number of state directions that inputs control, or that outputs observe."""
    rank: int
    """number of directions"""
    singular_values: list[float]
    """singular values, the largest first"""

class Crossing(Record):
    """A change of gain or phase that puts the closed loop on the border of stability."""
    frequency: float
    """frequency; null for a direct path [rad/s]"""
    margin: float
    """factor of the gain, angle [rad] of the phase, or distance from -1"""

class Margins(Record):
    """Margins of the loop that feedback closes."""
    feedback: float
    """sign of the feedback, +1 or -1"""
    stable: Optional[bool]
    """stability of the closed loop; null if undetermined"""
    gain: Optional[Crossing]
    """crossing with the factor nearest to 1"""
    phase: Optional[Crossing]
    """crossing with the angle nearest to 0"""
    delay: float
    """least delay that uses up the phase margin [s]"""
    modulus: Optional[Crossing]
    """least distance of the loop gain from -1"""
    gain_crossings: list[Crossing]
    """all crossings of the gain"""
    phase_crossings: list[Crossing]
    """all crossings of the phase"""
    closed_poles: list[complex]
    """poles of the closed loop [rad/s]"""
    not_determined: list[str]
    """a sentence on each undetermined value"""

class ChannelAnalysis(Record):
    """Analysis of one input and one output."""
    input: str
    """name of the input"""
    output: str
    """name of the output"""
    zeros: list[complex]
    """zeros; null for a system with delays [rad/s]"""
    gain_at_rest: float
    """gain at frequency 0 [SI]"""
    bandwidth: float
    """bandwidth [rad/s]"""
    margins: Margins
    """margins of the loop of this channel"""

class OperatingPoint(Record):
    """Values at which a diagram is linearized."""
    time: float
    """time [s]"""
    states: dict[str, float]
    """states [SI]"""
    rates: list[float]
    """derivatives of the states, or their change in a sample time [SI]"""
    inputs: dict[str, float]
    """inputs [SI]"""
    outputs: dict[str, float]
    """outputs [SI]"""

class MatrixErrors(Record):
    """Estimated errors of the matrices."""
    A: list[list[float]]
    """error of the matrix from the states to their derivatives [SI]"""
    B: list[list[float]]
    """error of the matrix from the inputs to the derivatives [SI]"""
    C: list[list[float]]
    """error of the matrix from the states to the outputs [SI]"""
    D: list[list[float]]
    """error of the matrix from the inputs to the outputs [SI]"""

class LinearResult(Record):
    """The result of a linear analysis: linear.json."""
    file: str
    """diagram file"""
    A: list[list[float]]
    """matrix from the states to their derivatives [SI]"""
    B: list[list[float]]
    """matrix from the inputs to the derivatives [SI]"""
    C: list[list[float]]
    """matrix from the states to the outputs [SI]"""
    D: list[list[float]]
    """matrix from the inputs to the outputs [SI]"""
    states: list[str]
    """names of the states"""
    inputs: list[str]
    """names of the inputs, then those of the delays"""
    outputs: list[str]
    """names of the outputs, then those of the delays"""
    delays: list[InnerDelay]
    """delays within the system"""
    units: ChannelUnits
    """SI units"""
    sample_time: float
    """sample time; 0 for a continuous system [s]"""
    poles: list[complex]
    """poles [rad/s]"""
    zeros: list[complex]
    """transmission zeros; null for a system with delays [rad/s]"""
    modes: list[Mode]
    """poles with frequency and damping"""
    stable: bool
    """stability without feedback"""
    controllability: Optional[Rank]
    """states that the inputs control; null for a system with delays"""
    observability: Optional[Rank]
    """states that the outputs observe; null for a system with delays"""
    channels: list[ChannelAnalysis]
    """each output of the first input, then of the second, ..."""
    margins: Optional[Margins]
    """margins of the only channel; missing with several"""
    point: OperatingPoint
    """operating point"""
    error: MatrixErrors
    """estimated errors"""
    method: str
    """sentence on the method"""
    notes: list[str]
    """kinks, held values, a point that is no equilibrium"""

class TrimmedValue(Record):
    """A number of the operating point."""
    name: str
    """name of the state, input or output"""
    value: float
    """value [SI]"""
    unit: str
    """SI unit; null if unknown or dimensionless"""
    free: bool
    """true if the search determines it"""
    at_bound: bool
    """true at a bound"""
    setting: str
    """name for --set; null if no file can set it"""

class Residual(Record):
    """A derivative, or an output minus its target."""
    name: str
    """name of the state or output"""
    value: float
    """residual [SI]"""

class TrimResult(Record):
    """The result of a trim: trim.json."""
    file: str
    """diagram file"""
    converged: bool
    """true at an operating point"""
    iterations: int
    """number of iterations"""
    residual: float
    """largest residual, each as a share of 1 or of its number"""
    states: list[TrimmedValue]
    """states"""
    inputs: list[TrimmedValue]
    """inputs"""
    outputs: list[TrimmedValue]
    """outputs"""
    residuals: list[Residual]
    """derivatives, and outputs minus their targets"""
