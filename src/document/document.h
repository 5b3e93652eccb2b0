// TOML documents whose every value remembers its file and line. Typed getters explain what was
// found and what is allowed; `finish()` refuses keys that nobody read, so a misspelt key is an
// error.
//
// Quantities are written as strings with their unit ("6378.137 km", "25.687 deg"); a unit of
// another dimension is an error. No domain knowledge lives here.
#pragma once

#include <toml++/toml.h>
#include <filesystem>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "document/input_error.h"
#include "quantity/quantity.h"

namespace antumbra {

// Parse "<number> <unit>". Units: length m km au nm um mm; angle deg arcmin arcsec rad; time s ms
// min h d. `where` opens the message of the InputError that is thrown otherwise.
Length parseLength(std::string_view text, const std::string& where);
Angle parseAngle(std::string_view text, const std::string& where);
Duration parseDuration(std::string_view text, const std::string& where);
// A finite number and nothing else.
double parseNumber(std::string_view text, const std::string& where);
// An integer and nothing else.
long parseInteger(std::string_view text, const std::string& where);

// One table of a document. Copies share the record of which keys were read.
class Table {
 public:
  Table(const toml::table& table, std::string file, std::string path);

  bool has(std::string_view key) const;
  bool holdsTable(std::string_view key) const;  // present, and a table
  // Required values: each throws InputError naming file, line, key, what was found, what is
  // allowed.
  std::string text(std::string_view key) const;
  double number(std::string_view key) const;
  long integer(std::string_view key) const;
  bool boolean(std::string_view key) const;
  Length length(std::string_view key) const;
  Angle angle(std::string_view key) const;
  Duration duration(std::string_view key) const;
  std::vector<double> numbers(std::string_view key) const;
  std::vector<std::string> texts(std::string_view key) const;
  // A value out of a closed list; the error lists what is allowed.
  std::string oneOf(std::string_view key, const std::vector<std::string>& allowed) const;
  // As above, with a default where the key is absent.
  std::string text(std::string_view key, const std::string& otherwise) const;
  double number(std::string_view key, double otherwise) const;
  long integer(std::string_view key, long otherwise) const;
  bool boolean(std::string_view key, bool otherwise) const;
  Length length(std::string_view key, Length otherwise) const;
  Angle angle(std::string_view key, Angle otherwise) const;
  Duration duration(std::string_view key, Duration otherwise) const;

  Table table(std::string_view key) const;
  std::optional<Table> tableIfPresent(std::string_view key) const;
  std::vector<Table> tables(std::string_view key) const;  // [[key]]; empty where absent
  std::vector<std::string> keys() const;

  // "file.toml:12: [section] key"
  std::string where(std::string_view key = {}) const;
  [[noreturn]] void fail(std::string_view key, const std::string& message) const;
  // Throws InputError on the first key that no getter has read, here or in any table taken from it.
  void finish() const;
  const std::string& file() const { return file_; }

 private:
  const toml::node& required(std::string_view key) const;
  const toml::node* find(std::string_view key) const;
  std::string textOf(std::string_view key, const char* wanted) const;

  const toml::table* table_;
  std::string file_;
  std::string path_;
  std::shared_ptr<std::set<std::string, std::less<>>> read_;
  std::shared_ptr<std::vector<Table>> children_;
};

// A parsed file; owns what its tables point into.
class Document {
 public:
  // Throws InputError if the file is missing, unreadable or not TOML (with the line).
  static Document load(const std::filesystem::path& file);
  static Document parse(std::string_view content, const std::string& name);
  const Table& root() const { return *root_; }

 private:
  Document() = default;
  std::shared_ptr<toml::table> content_;
  std::shared_ptr<Table> root_;
};

}  // namespace antumbra
