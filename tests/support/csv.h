// Reads the authority tables of tests/authorities: '#' lines are provenance, one header line,
// commas.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace antumbra {

class CsvRow {
 public:
  explicit CsvRow(std::map<std::string, std::string> fields) : fields_(std::move(fields)) {}
  const std::string& text(const std::string& column) const { return fields_.at(column); }
  double number(const std::string& column) const { return std::stod(fields_.at(column)); }
  bool empty(const std::string& column) const { return fields_.at(column).empty(); }

 private:
  std::map<std::string, std::string> fields_;
};

// Paths are relative to the source tree, where the tests run.
inline std::vector<CsvRow> readCsv(const std::string& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(file + ": cannot be read");
  std::vector<std::string> head;
  std::vector<CsvRow> rows;
  std::string line;
  while (std::getline(in, line)) {
    if (line.empty() || line[0] == '#') continue;
    std::vector<std::string> fields;
    std::istringstream words(line + ",");
    for (std::string w; std::getline(words, w, ',');) fields.push_back(w);
    if (head.empty()) {
      head = fields;
      continue;
    }
    std::map<std::string, std::string> row;
    for (std::size_t i = 0; i < head.size(); ++i) row[head[i]] = i < fields.size() ? fields[i] : "";
    rows.emplace_back(row);
  }
  return rows;
}

}  // namespace antumbra
