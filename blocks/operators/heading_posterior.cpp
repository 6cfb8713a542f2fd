#include "blocks/operators/heading_posterior.hpp"

#include "blocks/operators/precision_count.hpp"
#include "engine/model/block/declare.hpp"

namespace stepwire {

void HeadingPosterior::configure(Configure& is) {
  require_precision_of_each<&HeadingPosterior::direction, &HeadingPosterior::precision>(is, "direction");
}

void HeadingPosterior::declare(Declare<HeadingPosterior>& is) {
  is.block(
      "HeadingPosterior",
      {.doc = "How probable each of 72 headings is as the way back to an authorized region, from directions "
              "that are shown, each with its precision, and from the resistance that is felt under the "
              "second law of directionality, |F_max| sin(angle between the push and the way), which says how "
              "far off the last motion was but not to which side: both sides stay probable until another "
              "push tells them apart. A cue of precision 0 says nothing, and without any all headings are "
              "alike. The heading is the most probable one, or the last one as long as no other is `change` "
              "times as probable, and the mean of those within 15 degrees of it. "
              "`sure` is the probability that the way lies within `within` of it.",
       .source = "thesis 3.4.2, eq. 14-16; Bayesian observers: Ernst and Banks 2002, Nature 415:429",
       .timing = Timing::discrete});
  is.parameter<&HeadingPosterior::weber>({.doc = "error of a felt force as a share of it", .at_least = 0.0});
  is.parameter<&HeadingPosterior::unsure>(
      {.doc = "deviation of what is known of a free motion, as a share of it", .at_least = 0.0});
  is.parameter<&HeadingPosterior::threshold>(
      {.unit = "N", .doc = "error of a weak force", .above = 0.0, .required = true});
  is.parameter<&HeadingPosterior::forgetting>(
      {.doc = "exponent by which what was felt counts less at each judgement",
       .at_least = 0.0,
       .at_most = 1.0});
  is.parameter<&HeadingPosterior::within>(
      {.unit = "rad", .doc = "how near to the heading `sure` counts", .above = 0.0});
  is.parameter<&HeadingPosterior::change>(
      {.doc = "how much more probable than the last heading another must be to be chosen", .at_least = 1.0});
  is.input<&HeadingPosterior::direction>({.unit = "rad", .doc = "that is shown, one for each cue"});
  is.input<&HeadingPosterior::precision>(
      {.unit = "1/rad^2", .doc = "of each, of all that was seen; 0: nothing"});
  is.input<&HeadingPosterior::force>({.unit = "N", .doc = "resistance that is felt; 0: none is"});
  is.input<&HeadingPosterior::push>({.unit = "rad", .doc = "direction of the push that it resists"});
  is.input<&HeadingPosterior::maximum>(
      {.unit = "N", .doc = "resistance across the way, as learnt before; 0: nothing resists"});
  is.input<&HeadingPosterior::free>({.unit = "N", .doc = "that a free motion meets, as learnt before"});
  is.input<&HeadingPosterior::moving>(
      {.doc = "true while the hand moves; while it does not, what resists is known to be as much or more"});
  is.input<&HeadingPosterior::judged>(
      {.doc = "true at the ticks at which all this is judged; between them nothing changes"});
  is.output<&HeadingPosterior::heading>({.unit = "rad", .doc = "that is most probable"});
  is.output<&HeadingPosterior::deviation>({.unit = "rad", .doc = "circular deviation of the whole"});
  is.output<&HeadingPosterior::sure>({.doc = "probability that the way lies near the heading"});
  is.state<&HeadingPosterior::last>({.doc = "heading in rad, deviation in rad and sure, as judged last"});
  is.state<&HeadingPosterior::felt>(
      {.doc = "logarithm of the likelihood of what was felt, for each heading", .settable = false});
}

}  // namespace stepwire
