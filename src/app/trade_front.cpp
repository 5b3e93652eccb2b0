#include "app/trade_front.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "document/input_error.h"

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
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  auto const errorOf = [&](std::size_t i) { return std::max(points[i].error, errorFloor); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return points[a].cost != points[b].cost ? points[a].cost < points[b].cost
                                            : errorOf(a) < errorOf(b);
  });
  std::vector<bool> front(points.size(), false);
  double best = INFINITY;
  for (std::size_t i : order) {
    if (!std::isfinite(points[i].cost) || !(errorOf(i) < best)) continue;
    best = errorOf(i);
    front[i] = true;
  }
  return front;
}

TradeFront::TradeFront(std::string subject, std::string costKey, std::string errorKey,
                       double errorFloor)
    : subject_(std::move(subject)),
      costKey_(std::move(costKey)),
      errorKey_(std::move(errorKey)),
      errorFloor_(errorFloor) {}

void TradeFront::note(const std::string& key, const std::string& text) {
  notes_.emplace_back(key, text);
}

void TradeFront::add(RowTable::Row row) {
  points_.push_back({numberOf(row, costKey_), numberOf(row, errorKey_)});
  rows_.push_back(std::move(row));
}

std::string TradeFront::text(const std::string& format) const {
  auto const front = paretoFront(points_, errorFloor_);
  RowTable table;
  if (format == "json") {
    nlohmann::ordered_json all;
    all["subject"] = subject_;
    for (auto const& [key, text] : notes_) all[key] = text;
    all["cost"] = costKey_;
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
      return points_[a].cost < points_[b].cost;
    });
  for (std::size_t i : order) {
    RowTable::Row row = rows_[i];
    row.emplace_back("on_front", std::string(front[i] ? "yes" : format == "csv" ? "no" : ""));
    table.add(std::move(row));
  }
  if (format == "csv") return table.text("csv", {costKey_, errorKey_, "on_front"});
  std::string out;
  for (auto const& [key, text] : notes_) out += fmt::format("{}: {}\n", key, text);
  out += table.text("table", {costKey_, errorKey_, "on_front"});
  if (errorFloor_ > 0.0)
    out += fmt::format(
        "on_front: beaten by no other point in {} and {}; errors below {:.2g} count "
        "as that\n",
        costKey_, errorKey_, errorFloor_);
  else
    out += fmt::format("on_front: beaten by no other point in {} and {}\n", costKey_, errorKey_);
  if (!complete_) out += "interrupted: not every point was measured\n";
  return out;
}

void requireTradeFormat(const std::string& format) {
  if (format != "table" && format != "json" && format != "csv")
    throw InputError(fmt::format("--format: found \"{}\"; allowed: table, csv, json", format));
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
