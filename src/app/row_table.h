// Rows with named columns, printed as CSV, as a JSON array of objects or as a table for people.
// Numbers carry the decimals they are worth; a quantity that does not exist is blank, in JSON null.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace antumbra {

struct Decimal {
  double value = 0.0;
  int decimals = 0;
};
using Cell = std::variant<std::monostate, std::string, Decimal>;

inline Cell cell(double value, int decimals) { return Decimal{value, decimals}; }
inline Cell cell(std::optional<double> value, int decimals) {
  return value ? Cell(Decimal{*value, decimals}) : Cell();
}

class RowTable {
 public:
  using Row = std::vector<std::pair<std::string, Cell>>;
  // Columns are those of the first row; every row must have the same.
  void add(Row row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }
  // "csv", "json" or "table"; `columns` serve as heading when there is no row.
  std::string text(const std::string& format, const std::vector<std::string>& columns) const;

 private:
  std::vector<Row> rows_;
};

std::string textOf(const Cell& cell);

}  // namespace antumbra
