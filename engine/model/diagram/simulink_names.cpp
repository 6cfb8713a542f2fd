#include "engine/model/diagram/simulink_names.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace stepwire::diagram {

namespace {

/// Names of Simulink blocks in lower case, separated by blanks, and their counterpart here.
struct Answer {
  std::string_view names, answer;
};

constexpr Answer answers[] = {
    Answer{"scope floatingscope display toworkspace tofile outport out1 out xygraph",
           "record the signal and draw it: `record`, `figure`"},
    Answer{"transferfcn transferfunctionfcn zeropole zeropolegain",
           "use TransferFunction (numerator, denominator)"},
    Answer{"discretetransferfcn discretefilter discretezeropole discretefirfilter",
           "use DiscreteTransferFunction"},
    Answer{"statespacesystem", "use StateSpace"},
    Answer{"discretestatespacesystem", "use DiscreteStateSpace"},
    Answer{"matlabfunction matlabfcn fcn sfunction interpretedmatlabfunction",
           "use Expression for a formula, or write a block: `--blocks DIR`"},
    Answer{"ratetransition", "none is needed: give blocks their period by `every`; ZeroOrderHold samples"},
    Answer{"memory", "use UnitDelay"},
    Answer{"transportdelay variabletransportdelay variabletimedelay",
           "use TransportDelay, whose delay may be a signal"},
    Answer{"buscreator",
           "write a bus: `wrench: {fields: {force: f, torque: t}}`; Mux joins signals to a vector"},
    Answer{"busselector", "name the field: `wrench.force`; Select picks elements of a vector"},
    Answer{"busassignment", "write a bus of the fields that are meant"},
    Answer{"randomnumber uniformrandomnumber bandlimitedwhitenoise whitenoise",
           "use Noise (deviation, or power for a given spectral density; distribution: uniform)"},
    Answer{"counterlimited counterfreerunning updowncounter", "use Counter (upper, beyond: wrap)"},
    Answer{"discretetimeintegrator", "use DiscreteIntegrator"},
    Answer{"discretepidcontroller", "use DiscretePID"},
    Answer{"pidcontroller pidcontroller2dof",
           "use PID: kp, ki, kd, tau = 1/N; weight_p and weight_d for two degrees of freedom"},
    Answer{"relationaloperator comparetoconstant comparetozero", "use Compare"},
    Answer{"logicaloperator combinatoriallogic", "use Logic"},
    Answer{"detectrisepositive detectrisenonnegative detectfallnegative detectchange detectincrease",
           "use EdgeDetect"},
    Answer{"multiportswitch manualswitch", "use Switch (then, control, else)"},
    Answer{"1dlookuptable lookuptabledynamic", "use LookupTable (points, values)"},
    Answer{"2dlookuptable", "use LookupTable2D (rows, columns, values)"},
    Answer{"ndlookuptable prelookup interpolationusingprelookup", "use LookupTableND (points, values)"},
    Answer{"chart stateflow stateflowchart truthtable", "use StateMachine"},
    Answer{"signalgenerator sinewave", "use Sine, Pulse or Chirp"},
    Answer{"pulsegenerator", "use Pulse"},
    Answer{"chirpsignal", "use Chirp"},
    Answer{"fromfile fromworkspace fromspreadsheet repeatingsequence signaleditor signalbuilder",
           "use FromFile with a table"},
    Answer{"inport in1", "name it under `inputs:` of the file"},
    Answer{"subsystem model atomicsubsystem referencedmodel", "use a part: `{diagram: part.yaml}`"},
    Answer{"enabledsubsystem triggeredsubsystem enabledandtriggeredsubsystem ifactionsubsystem "
           "resettablesubsystem",
           "use a part with `enable` or `trigger`"},
    Answer{"goto from datastoreread datastorewrite datastorememory",
           "write the name of the signal where it is read"},
    Answer{"stopsimulation", "write `stop_when`, or use Assert"},
    Answer{"add subtract sumofelements bias", "use Sum (signs: \"+-\")"},
    Answer{"divide1 mathfunction sqrtfunction", "use Expression, Divide, Sqrt or Trig"},
    Answer{"trigonometricfunction", "use Trig"},
    Answer{"minmaxrunningresettable", "use MinMax with a UnitDelay"},
    Answer{"saturationdynamic deadzonedynamic ratelimiterdynamic",
           "use the block without `Dynamic`: its limits may be signals"},
    Answer{"ratelimit", "use RateLimiter"},
    Answer{"coulombviscousfriction", "use Coulomb"},
    Answer{"ground", "write the number 0"},
    Answer{"datatypeconversion signalspecification convert",
           "none is needed: every signal is a number with a unit"},
    Answer{"gainmatrix", "use MatrixGain"},
    Answer{"vectorconcatenate", "use Mux"},
    Answer{"matrixconcatenate", "use Concatenate (side by side) or Stack"},
    Answer{"selector", "use Select"},
    Answer{"firstorderholdd firstorderhold", "use FromFile or Lag; ZeroOrderHold samples"},
    Answer{"kalmanfiltertimevarying extendedkalmanfilter", "use KalmanFilter"},
    Answer{"algebraicconstraint ic", "use InitialGuess in a loop, with `algebraic_loops: solve`"},
    Answer{"clocksignal digitalclock", "use Clock"},
    Answer{"assertion checkstaticrange", "use Assert, or a claim"},
};

std::string plain(const std::string& name) {
  std::string letters;
  for (const char c : name)
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      letters += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return letters;
}

bool holds(std::string_view names, std::string_view wanted) {
  for (std::size_t at = 0; at < names.size();) {
    const std::size_t end = std::min(names.find(' ', at), names.size());
    if (names.substr(at, end - at) == wanted) return true;
    at = end + 1;
  }
  return false;
}

}  // namespace

std::string answer_to_simulink(const std::string& name) {
  const std::string wanted = plain(name);
  for (const Answer& answer : answers)
    if (!wanted.empty() && holds(answer.names, wanted)) return std::string(answer.answer);
  return {};
}

}  // namespace stepwire::diagram
