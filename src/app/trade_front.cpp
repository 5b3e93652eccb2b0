#include "app/trade_front.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "document/input_error.h"
#include "document/whole_file.h"

namespace antumbra {
namespace {

volatile std::sig_atomic_t askedToStop = 0;

void stopWalking(int) {
  if (askedToStop) {
    std::signal(SIGINT, SIG_DFL);
    std::raise(SIGINT);
  }
  askedToStop = 1;
}

double numberOf(const RowTable::Row& row, const std::string& key) {
  for (auto const& [name, value] : row)
    if (name == key)
      if (auto const* number = std::get_if<Decimal>(&value)) return number->value;
  throw std::logic_error(fmt::format("trade: a row without a number \"{}\"", key));
}

}  // namespace

std::vector<bool> paretoFront(const std::vector<TradePoint>& points, double errorFloor) {
  std::vector<CostlyPoint> all;
  for (auto const& p : points) all.push_back({{p.cost}, p.error});
  return paretoFront(all, errorFloor, 0.0, 0.0);
}

std::vector<bool> paretoFront(const std::vector<CostlyPoint>& points, double errorFloor,
                              double tolerance, double errorMargin) {
  auto const errorOf = [&](std::size_t i) { return std::max(points[i].error, errorFloor); };
  auto const finite = [&](std::size_t i) {
    return std::isfinite(points[i].error) &&
           std::all_of(points[i].costs.begin(), points[i].costs.end(),
                       [](double c) { return std::isfinite(c); });
  };
  auto const beats = [&](std::size_t a, std::size_t b) {
    if (!finite(a) || !(errorOf(a) <= errorOf(b))) return false;
    bool better = errorOf(a) + errorMargin < errorOf(b), equal = !better;
    for (std::size_t k = 0; k < points[a].costs.size(); ++k) {
      double const mine = points[a].costs[k], its = points[b].costs[k];
      if (mine > its * (1.0 + tolerance)) return false;
      if (mine * (1.0 + tolerance) < its) better = true, equal = false;
    }
    return better || (equal && errorOf(a) == errorOf(b) && a < b);
  };
  std::vector<bool> front(points.size(), true);
  for (std::size_t i = 0; i < points.size(); ++i) {
    front[i] = finite(i);
    for (std::size_t j = 0; j < points.size() && front[i]; ++j)
      if (j != i && beats(j, i)) front[i] = false;
  }
  return front;
}

TradeFront::TradeFront(std::string subject, std::string costKey, std::string errorKey,
                       double errorFloor)
    : subject_(std::move(subject)),
      errorKey_(std::move(errorKey)),
      costKeys_{std::move(costKey)},
      errorFloor_(errorFloor) {}

void TradeFront::alsoCost(const std::string& key) { costKeys_.push_back(key); }

void TradeFront::tolerate(double tolerance, double errorMargin) {
  tolerance_ = tolerance;
  errorMargin_ = errorMargin;
}

std::vector<bool> TradeFront::front() const {
  return paretoFront(points_, errorFloor_, tolerance_, errorMargin_);
}

void TradeFront::note(const std::string& key, const std::string& text) {
  notes_.emplace_back(key, text);
}

void TradeFront::add(RowTable::Row row) {
  std::vector<double> costs;
  for (auto const& key : costKeys_) costs.push_back(numberOf(row, key));
  points_.push_back({costs, numberOf(row, errorKey_)});
  rows_.push_back(std::move(row));
}

std::string TradeFront::text(const std::string& format) const {
  auto const front = this->front();
  std::string const& costKey = costKeys_.front();
  std::string const costs = fmt::format("{}", fmt::join(costKeys_, ", "));
  RowTable table;
  if (format == "json") {
    nlohmann::ordered_json all;
    all["subject"] = subject_;
    for (auto const& [key, text] : notes_) all[key] = text;
    all["cost"] = costKey;
    all["costs"] = costKeys_;
    all["error"] = errorKey_;
    all["error_floor"] = errorFloor_;
    all["complete"] = complete_;
    for (auto const& row : rows_) table.add(row);
    all["rows"] = nlohmann::ordered_json::parse(table.text("json", {}));
    for (std::size_t i = 0; i < rows_.size(); ++i) all["rows"][i]["on_front"] = bool(front[i]);
    return all.dump(2) + "\n";
  }
  std::vector<std::size_t> order(rows_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  if (format == "table")
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return points_[a].costs[0] < points_[b].costs[0];
    });
  for (std::size_t i : order) {
    RowTable::Row row = rows_[i];
    row.emplace_back("on_front", std::string(front[i] ? "yes" : format == "csv" ? "no" : ""));
    table.add(std::move(row));
  }
  if (format == "csv") return table.text("csv", {costKey, errorKey_, "on_front"});
  std::string out;
  for (auto const& [key, text] : notes_) out += fmt::format("{}: {}\n", key, text);
  out += table.text("table", {costKey, errorKey_, "on_front"});
  out += fmt::format("on_front: beaten by no other point in {}, {}", errorKey_, costs);
  if (errorFloor_ > 0.0) out += fmt::format("; errors below {:.2g} count as that", errorFloor_);
  if (tolerance_ > 0.0)
    out += fmt::format("; costs within {:.0f} % count as equal", 100.0 * tolerance_);
  out += '\n';
  if (!complete_) out += "interrupted: not every point was measured\n";
  return out;
}

void requireTradeOutput(const std::string& format, const std::string& output) {
  if (format != "table" && format != "json" && format != "csv")
    throw InputError(fmt::format("--format: found \"{}\"; allowed: table, csv, json", format));
  if (!output.empty() && output != "-") requireWritable(output, "-o");
}

TradeProgress::TradeProgress(std::string what, std::size_t points)
    : what_(std::move(what)), points_(points), terminal_(isatty(STDERR_FILENO) != 0) {
  askedToStop = 0;
  before_ = std::signal(SIGINT, stopWalking);
}

TradeProgress::~TradeProgress() {
  if (terminal_) fmt::print(stderr, "\r{: <78}\r", "");
  std::signal(SIGINT, before_);
}

bool TradeProgress::interrupted() { return askedToStop != 0; }

void TradeProgress::show(const std::string& point, double share) {
  constexpr int width = 24;
  double const done =
      (static_cast<double>(done_) + share) / static_cast<double>(std::max<std::size_t>(points_, 1));
  int const percent = static_cast<int>(100.0 * done);
  if (percent == shown_) return;
  shown_ = percent;
  int const full = static_cast<int>(done * width);
  fmt::print(stderr, "\r{} [{:=<{}}{: <{}}] {:3} % {: <30.30}", what_, "", full, "", width - full,
             percent, point);
  std::fflush(stderr);
}

void TradeProgress::at(const std::string& point, double share) {
  if (terminal_) show(point, share);
}

void TradeProgress::finished(const std::string& point) {
  ++done_;
  shown_ = -1;
  if (terminal_)
    show(point, 0.0);
  else
    fmt::print(stderr, "{} {} of {}: {}\n", what_, done_, points_, point);
}

}  // namespace antumbra
