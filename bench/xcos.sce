// Xcos on the workloads: the same block diagrams from the blocks of its palettes, compiled and run by its engine.
//   scilab-cli -nb -f bench/xcos.sce -args FILE 10 100 1000
// runs W1, and W2 with so many blocks, holds the results against the reference values, and writes the processor time
// of a step to FILE as JSON, one result to a line. Exit status 1 if a result is wrong.
//
// Blocks and wires go to the compiler (c_pass2) as they are, without a drawing: with a drawing, a diagram of 1,000
// blocks takes 20 s to compile. What runs is the same. The solver is Xcos' explicit Runge-Kutta with fixed steps
// (number 6, "RK45"): the classic method of order 4, so results agree as closely as ours do.

step = 1e-3;
runge_kutta = 6;
tolerance = 1e-11;

// A block of a palette with these parameters; zero crossings are off, since steps are fixed.
function model = block(name, rpar, ipar)
  execstr("palette = " + name + "(""define"")");
  model = palette.model;
  model.rpar = rpar(:);
  model.ipar = ipar(:);
  model.nzcross = 0;
  model.nmode = 0;
endfunction

// The newer of two kinds of gain; GAINBLK_f makes a step twice as long.
function model = gain(factor)
  model = block("GAINBLK", factor, []);
endfunction

function model = total(signs)
  model = block("SUMMATION", [], signs);
  model.in = -ones(signs(:));
  model.in2 = 2 * model.in;
  model.intyp = -model.in;
endfunction

function model = product()
  model = block("PRODUCT", [], [1 1]);
endfunction

function model = saturation(lower, upper)
  model = block("SATURATION", [upper lower], []);
endfunction

// A formula of u1, compiled as the block's dialogue does.
function model = expression(formula)
  scicos_getvalue = setvalue;
  %scicos_prob = %f;
  %scicos_context = struct();
  palette = EXPRESSION("define");
  palette.graphics.exprs = ["1"; formula; "0"];
  palette = EXPRESSION("set", palette);
  model = palette.model;
endfunction

// An event every step, the first at time 0.
function model = ticking()
  model = block("EVTDLY_c", [step 0], []);
  model.firing = 0;
endfunction

// W1: each line is a block and what feeds it. Xcos has no discrete PID, so its sums and delays are blocks of their
// own here; what a discrete block takes from a continuous one is sampled first.
function lines = w1_lines()
  integrator = block("INTEGRAL_m", [], []);
  absolute = block("ABS_VALUE", [], []);
  sample = block("SAMPHOLD_m", [], []);
  delay = block("DOLLAR_f", [], []);
  lines = list(..
    list("hand", block("GENSIN_f", [2 %pi 0.3], []), []), ..
    list("Fh", gain(5), "hand"), ..
    list("Fnet", total([1 -1]), ["Fh" "Fd"]), ..
    list("acc", gain(1), "Fnet"), ..
    list("accmm", gain(1000), "acc"), ..
    list("v", integrator, "accmm"), ..
    list("x", integrator, "v"), ..
    list("absv", absolute, "v"), ..
    list("absz", absolute, "z"), ..
    list("pvz", product(), ["absv" "z"]), ..
    list("pzv", product(), ["v" "absz"]), ..
    list("gA", gain(36.2095), "v"), ..
    list("gB", gain(10.614), "pvz"), ..
    list("gG", gain(-7.0773), "pzv"), ..
    list("zdot", total([1 -1 -1]), ["gA" "gB" "gG"]), ..
    list("z", integrator, "zdot"), ..
    list("amp", block("CLSS", [-200 200 1 0], []), "usat"), ..
    list("isat", saturation(0, 0.35), "amp"), ..
    list("c", expression("(((-9.37*u1+10.22)*u1-4.33)*u1+0.89)*u1+0.02"), "isat"), ..
    list("alpha", expression("((72.8*u1-42.88)*u1+14.83)*u1+0.29"), "isat"), ..
    list("cv", product(), ["c" "v"]), ..
    list("az", product(), ["alpha" "z"]), ..
    list("Fd", total([1 1]), ["cv" "az"]), ..
    list("x_sampled", sample, ["x" "clock"]), ..
    list("Fh_sampled", sample, ["Fh" "clock"]), ..
    list("Fd_sampled", sample, ["Fd" "clock"]), ..
    list("xq", block("QUANT_f", 0.02, 1), "x_sampled"), ..
    list("region", block("DEADBAND", [5 -4], []), "xq"), ..
    list("aerr", absolute, "region"), ..
    list("gate", product(), ["region" "Fh_sampled"]), ..
    list("slope", gain(1), "aerr"), ..
    list("two", block("CONST_m", 2, []), []), ..
    list("P1", total([1 1]), ["slope" "two"]), ..
    list("zero", block("CONST_m", 0, []), []), ..
    list("Pd", block("SWITCH2_m", 0, 1), ["P1" "gate" "zero"]), ..
    list("absF", absolute, "Fd_sampled"), ..
    list("e", total([1 -1]), ["Pd" "absF"]), ..
    list("e_last", delay, ["e" "clock"]), ..
    list("rise", total([1 -1]), ["e" "e_last"]), ..
    list("P", gain(0.005), "e"), ..
    list("D", gain(1e-5 / step), "rise"), ..
    list("e_area", gain(0.5 * step), "e"), ..
    list("I_sum", total([1 1]), ["I" "e_area"]), ..
    list("I_next", saturation(0, 0.35), "I_sum"), ..
    list("I", delay, ["I_next" "clock"]), ..
    list("pid", total([1 1 1]), ["P" "I" "D"]), ..
    list("usat", saturation(0, 0.35), "pid"), ..
    list("clock", ticking(), "clock"));
endfunction

// The compiler's lists: blocks, wires and events as rows [from port to port].
function [blocks, wires, events] = w1()
  lines = w1_lines();
  names = [];
  for line = lines
    names($ + 1) = line(1);
  end
  blocks = list(); wires = []; events = [];
  for b = 1:size(lines)
    blocks(b) = lines(b)(2);
    port = 0;
    for source = lines(b)(3)
      from = find(names == source);
      if source == "clock" then
        events = [events; from 1 b 1];
      else
        port = port + 1;
        wires = [wires; from 1 b port];
      end
    end
    // What follows time is computed always, and at every event.
    if blocks(b).dep_ut($) then
      events = [events; find(names == "clock") 1 b 0; 0 0 b 0];
    end
  end
endfunction

function [blocks, wires, events] = w2(count)
  cells = count / 5;
  blocks = list(block("GENSIN_f", [1 2*%pi 0], []), gain(0.1));
  wires = zeros(1 + 7 * cells, 4);
  wires(1, :) = [1 1 2 1];
  difference = total([1 -1]); both = total([1 1]); integrator = block("INTEGRAL_m", [], []);
  u = 1;
  for j = 0:cells - 1
    e = 3 + 5 * j; g = e + 1; x = e + 2; p = e + 3; next = e + 4;
    blocks(e) = difference;
    blocks(g) = gain(1 + modulo(j, 7));
    blocks(x) = integrator;
    blocks(p) = gain(0.9 + 0.01 * modulo(j, 5));
    blocks(next) = both;
    wires(1 + 7 * j + (1:7), :) = [u 1 e 1; x 1 e 2; e 1 g 1; g 1 x 1; x 1 p 1; p 1 next 1; 2 1 next 2];
    u = next;
  end
  timed = [1, 5:5:count]';
  events = [zeros(timed), zeros(timed), timed, zeros(timed)];
endfunction

function compiled = compile(blocks, wires, events)
  places = list();
  for b = 1:size(blocks)
    places(b) = b;
  end
  compiled = c_pass2(blocks, wires, events, places, places, "silent");
endfunction

// Runs from the start; the states at the end and the processor time of the run [s]. The third tolerance is of times:
// with a larger one the engine takes one step more than the time has, and writes over its memory.
function [states, seconds] = simulate(compiled, steps)
  tolerances = [1e-12; 1e-12; 1e-14; 1e6; 0; runge_kutta; step];
  stop = steps * step;
  [state, time] = scicosim(compiled.state, 0, stop, compiled.sim, "start", tolerances);
  timer();
  [state, time] = scicosim(state, 0, stop, compiled.sim, "run", tolerances);
  seconds = timer();
  states = state.x;
  [state, time] = scicosim(state, stop, stop, compiled.sim, "finish", tolerances);
endfunction

function check(workload, value, reference)
  if or(abs(value - reference) > tolerance * abs(reference)) then
    mprintf("%s by Xcos: %.16g where %.16g is right\n", workload, value(:), reference(:));
    exit(1);
  end
endfunction

// Runs so many steps and holds the states against the reference; then runs more, and says what those cost more.
function cost = cost_of_step(workload, compiled, steps, seen, reference, more)
  [states, short] = simulate(compiled, steps);
  check(msprintf("%s after %d steps", workload, steps), seen(states), reference);
  [states, long] = simulate(compiled, steps + more);
  cost = (long - short) / more;
endfunction

function write_cost(file, workload, count, cost)
  mfprintf(file, "{""workload"":""%s"",""blocks"":%d,""by"":""Xcos"",""unit"":""ns per step"",""value"":%.6g}\n", ..
           workload, count, cost * 1e9);
endfunction

function run_w1(file)
  [blocks, wires, events] = w1();
  deff("same = all_of(states)", "same = states");
  reference = [0.500905335020262; -22.0660615859992; 1.10514893010915; 0.273227421053629];
  write_cost(file, "W1", 35, cost_of_step("W1", compile(blocks, wires, events), 2000, all_of, reference, 40000));
endfunction

function run_w2(file, count)
  references = [10 1000 -0.0748070793824835; 100 300 1.62651668141925; 1000 40 0.395875330268821;
                10000 5 0.0627443518970763];
  reference = references(references(:, 1) == count, :);
  [blocks, wires, events] = w2(count);
  workload = msprintf("W2 %d", count);
  compiled = compile(blocks, wires, events);
  write_cost(file, workload, size(blocks), ..
             cost_of_step(workload, compiled, reference(2), sum, reference(3), 2e6 / count));
endfunction

function main()
  loadXcosLibs();
  arguments = sciargs();
  given = arguments(find(arguments == "-args") + 1:$);
  file = mopen(given(1), "w");
  run_w1(file);
  for count = strtod(given(2:$))'
    run_w2(file, count);
  end
  mclose(file);
endfunction

if execstr("main()", "errcatch") <> 0 then
  mprintf("%s\n", lasterror());
  exit(2);
end
exit(0);
