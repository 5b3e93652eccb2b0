// What every subcommand of `antumbra trade` measures and prints: points that a set of knobs can
// take, each with an error and a cost, and which of them no other point beats in both (the Pareto
// front).
//
// An error below `errorFloor`, what the reference itself is uncertain by, counts as the floor: two
// points below it differ by cost alone. As JSON, an object that tools/plot reads:
//   {"subject": "sky", <notes: "scene", "device", "reference"...>,
//    "cost": <key of the cost>, "error": <key of the error>, "error_floor": number,
//    "complete": false where the walk was interrupted,
//    "rows": [{<key with its unit>: value..., "on_front": true or false}]}
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/row_table.h"

namespace antumbra {

// Which points of (cost, error) no other one beats: none is as good in both and better in one. Of
// equal points the first. Points whose cost or error is not finite are on no front.
struct TradePoint {
  double cost, error;
};
std::vector<bool> paretoFront(const std::vector<TradePoint>& points, double errorFloor = 0.0);
// The same for several costs and measured ones; see TradeFront::tolerate.
struct CostlyPoint {
  std::vector<double> costs;
  double error;
};
std::vector<bool> paretoFront(const std::vector<CostlyPoint>& points, double errorFloor,
                              double tolerance, double errorMargin);

class TradeFront {
 public:
  // Keys of the columns that hold cost and error.
  TradeFront(std::string subject, std::string costKey, std::string errorKey,
             double errorFloor = 0.0);
  // Another cost, for fronts of several: a point stays on the front unless another one is no worse
  // in anything and better in something. `tolerance`: relative, of every cost, where times are
  // measured; `errorMargin`: the least difference of errors that counts as better.
  void alsoCost(const std::string& key);
  void tolerate(double tolerance, double errorMargin);
  // What was measured, on what, against what; printed above the table, in JSON a key of its own.
  void note(const std::string& key, const std::string& text);
  // Throws std::logic_error where cost or error is missing or no number.
  void add(RowTable::Row row);
  void markIncomplete() { complete_ = false; }
  bool empty() const { return rows_.empty(); }
  // "table" (by cost, points of the front marked), "csv" or "json".
  std::string text(const std::string& format) const;

 private:
  std::vector<bool> front() const;

  std::string subject_, errorKey_;
  std::vector<std::string> costKeys_;  // the first is the one to plot
  double errorFloor_, tolerance_ = 0.0, errorMargin_ = 0.0;
  std::vector<std::pair<std::string, std::string>> notes_;
  std::vector<RowTable::Row> rows_;
  std::vector<CostlyPoint> points_;
  bool complete_ = true;
};

// Throws InputError unless `format` is table, csv or json and `output` ("-": standard output) can
// be written: before the measurement, not after it.
void requireTradeOutput(const std::string& format, const std::string& output);

// How far a walk has come, on standard error: a bar that is rewritten on a terminal, a line for
// each point elsewhere. While one lives, the first interrupt (Control-C) only sets interrupted(),
// so that a walk ends with the points it has; the second ends the program.
class TradeProgress {
 public:
  TradeProgress(std::string what, std::size_t points);
  ~TradeProgress();
  TradeProgress(const TradeProgress&) = delete;
  TradeProgress& operator=(const TradeProgress&) = delete;
  // A point is being measured, `share` of it done.
  void at(const std::string& point, double share);
  void finished(const std::string& point);
  static bool interrupted();

 private:
  void show(const std::string& point, double share);
  std::string what_;
  std::size_t points_, done_ = 0;
  int shown_ = -1;
  bool terminal_;
  void (*before_)(int) = nullptr;
};

}  // namespace antumbra
