#include <algorithm>
#include <cmath>

#include "engine/analyse/statistics/descriptive.hpp"
#include "engine/view/plot/plot_tools.hpp"

namespace stepwire::plot {
namespace {

struct BandOptions {
  std::vector<double> shares{};  ///< of the runs in the bands; empty: 50 % and 90 %
};

constexpr std::size_t band_places = 240;  // along x

/// Interpolates between two rows of a curve with increasing x; NaN outside of it.
double value_at(const geometry::Curve& curve, double x) {
  const std::vector<double>& all = curve.columns[0];
  const auto above = std::ranges::lower_bound(all, x);
  if (above == all.end() || (above == all.begin() && *above != x)) return query::nothing;
  const auto i = static_cast<std::size_t>(above - all.begin());
  const std::vector<double>& y = curve.columns[1];
  if (all[i] == x) return y[i];
  const double share = (x - all[i - 1]) / (all[i] - all[i - 1]);
  return y[i - 1] + share * (y[i] - y[i - 1]);
}

/// Returns the sorted values of all curves of a group at an x.
std::vector<double> values_at(const geometry::Curves& all, std::size_t group, double x) {
  std::vector<double> values;
  for (const geometry::Curve& curve : all.curves)
    if (curve.group == group)
      if (const double value = value_at(curve, x); !std::isnan(value)) values.push_back(value);
  std::ranges::sort(values);
  return values;
}

/// Quantiles over the curves along x: the median, and the ends of a band for each share.
struct Band {
  std::vector<double> x, median;
  std::vector<std::vector<double>> low, high;  ///< [share]
};

Band band_of(const geometry::Curves& all, std::size_t group, const std::vector<double>& shares) {
  geometry::Extent extent;
  for (const geometry::Curve& curve : all.curves)
    if (curve.group == group)
      for (const double x : curve.columns[0]) extent.add(x);
  Band band{{}, {}, std::vector<std::vector<double>>(shares.size()), {}};
  band.high = band.low;
  for (std::size_t place = 0; place <= band_places; ++place) {
    const double x = place == band_places ? extent.high
                                          : extent.low + extent.width() * static_cast<double>(place) /
                                                             static_cast<double>(band_places);
    const std::vector<double> values = values_at(all, group, x);
    if (values.empty()) continue;
    band.x.push_back(x);
    band.median.push_back(statistics::hazen_quantile(values, 0.5));
    for (std::size_t i = 0; i < shares.size(); ++i) {
      band.low[i].push_back(statistics::hazen_quantile(values, 0.5 * (1.0 - shares[i])));
      band.high[i].push_back(statistics::hazen_quantile(values, 0.5 * (1.0 + shares[i])));
    }
  }
  return band;
}

void draw_group(const Band& band, std::size_t entry, const std::string& legend, PlotBuilder& plot) {
  for (std::size_t i = 0; i < band.low.size(); ++i) {
    for (const auto* edge : {&band.low[i], &band.high[i]})
      for (const double value : *edge) plot.y.add(value);
    plot.add_below(BandMark{band.x, band.low[i], band.high[i], curve_color(entry)});
  }
  const geometry::Curve median{{band.x, band.median}, entry};
  plot.cover({median});
  plot.add(LineMark{{plane_rows(median)}, {curve_color(entry), 2.0}, 0.0, legend});
}

void draw_bands(const Panel& panel, std::span<const record::Recording> recordings, PlotBuilder& plot) {
  const query::Series &x = *panel.find("x"), &y = *panel.find("y");
  const geometry::Curves all = gather(panel, recording_of(panel, recordings), {&x, &y});
  const auto& own = panel.options<BandOptions>().shares;
  const std::vector<double> shares = own.empty() ? std::vector{0.5, 0.9} : own;
  plot.label("x", x);
  plot.label("y", y);
  for (std::size_t group = 0; group < all.groups.size(); ++group) {
    const std::string own = all.labels.empty() ? "median" : all.legends[group];
    draw_group(band_of(all, group, shares), group, group < panel.legend.size() ? panel.legend[group] : own,
               plot);
  }
  set_line_ranges(plot);
}

void read_shares(Panel& panel, const yaml::Node& node, const query::NamesReading& read) {
  yaml::Key share = yaml::form::above_zero(yaml::form::number());
  share.most = 1.0;
  for (const yaml::Node& item : node.as_list())
    if (const auto number = read.number(item, share)) panel.options<BandOptions>().shares.push_back(*number);
}

}  // namespace

PlotKind band_plot() {
  PlotKind kind{
      "band",
      "quantiles over the runs of a sweep: the median, and bands in which the middle half and 90 % of the "
      "runs lie; x rises in each run, as time does",
      {{"x", "along the horizontal axis: EXPR or EXPR in UNIT", true},
       {"y", "what has a value in each run", true},
       {"by", "one band for each value of this, such as a swept parameter"}},
      {{"shares", "which shares of the runs lie in the bands: [50 %, 90 %]",
        yaml::form::one_or_list(yaml::form::number()), read_shares}},
      true,
      draw_bands};
  kind.lacks = {KeyNeeds::color_bar};
  return kind;
}

}  // namespace stepwire::plot
