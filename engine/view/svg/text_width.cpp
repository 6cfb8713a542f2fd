#include "engine/view/svg/text_width.hpp"

#include <algorithm>
#include <array>

namespace stepwire::svg {
namespace {

/// From blank to tilde, in thousandths of the font size.
constexpr std::array<short, 95> widths{
    318, 401, 460, 838, 636, 950, 780, 275, 390, 390, 500, 838, 318, 361,  318, 337, 636, 636, 636,
    636, 636, 636, 636, 636, 636, 636, 337, 337, 838, 838, 838, 531, 1000, 684, 686, 698, 770, 632,
    575, 775, 752, 295, 295, 656, 557, 863, 748, 787, 603, 787, 695, 635,  611, 732, 684, 989, 685,
    611, 685, 390, 337, 390, 838, 500, 500, 613, 635, 550, 635, 615, 352,  635, 634, 278, 278, 579,
    278, 974, 634, 612, 635, 635, 411, 521, 392, 634, 592, 818, 592, 592,  525, 636, 337, 636, 838};
/// Other letters: European ones, and wide signs from the dashes on.
constexpr short european = 800, wide = 1000;

}  // namespace

double text_width(std::string_view text) {
  int sum = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) sum += widths[byte - 0x20u];
    if (byte >= 0xc0) sum += byte < 0xe2 ? european : wide;  // first byte of a UTF-8 letter
  }
  return sum / 1000.0;
}

double fitted_size(std::string_view text, double wanted, double room) {
  const double width = text_width(text);
  return width * wanted > room ? room / width : wanted;
}

}  // namespace stepwire::svg
