#include "document/document.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <sstream>

namespace antumbra {
namespace {

struct Unit {
  std::string_view name;
  double si;
};
constexpr Unit kLengths[] = {{"m", 1.0},   {"km", 1e3},  {"au", astronomicalUnit.si},
                             {"mm", 1e-3}, {"um", 1e-6}, {"nm", 1e-9}};
constexpr Unit kAngles[] = {
    {"deg", degree.si}, {"arcmin", arcminute.si}, {"arcsec", arcsecond.si}, {"rad", 1.0}};
constexpr Unit kTimes[] = {{"s", 1.0}, {"ms", 1e-3}, {"min", 60.0}, {"h", 3600.0}, {"d", 86400.0}};

std::string_view trimmed(std::string_view text) {
  auto const first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

template <std::size_t N>
double parseWithUnit(std::string_view given, const Unit (&units)[N], const char* dimension,
                     const std::string& where) {
  std::string allowed;
  for (auto const& u : units) allowed += (allowed.empty() ? "" : ", ") + std::string(u.name);
  auto const explain = [&](const char* wrong) {
    return InputError(fmt::format("{}: {}: found \"{}\"; allowed: a number and a unit of {} ({})",
                                  where, wrong, given, dimension, allowed));
  };
  std::string_view const text = trimmed(given);
  double value = 0.0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) throw explain("not a number with a unit");
  if (!std::isfinite(value)) throw explain("not a finite number");
  std::string_view const unit = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
  for (auto const& u : units)
    if (u.name == unit) return value * u.si;
  throw explain(unit.empty() ? "no unit" : "wrong unit");
}

const char* kindOf(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date";
  }
}

}  // namespace

Length parseLength(std::string_view text, const std::string& where) {
  return Length(parseWithUnit(text, kLengths, "length", where));
}
Angle parseAngle(std::string_view text, const std::string& where) {
  return Angle(parseWithUnit(text, kAngles, "angle", where));
}
Duration parseDuration(std::string_view text, const std::string& where) {
  return Duration(parseWithUnit(text, kTimes, "time", where));
}
double parseNumber(std::string_view given, const std::string& where) {
  std::string_view text = trimmed(given);
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    throw InputError(fmt::format("{}: found \"{}\"; allowed: a finite number", where, given));
  return value;
}
long parseInteger(std::string_view given, const std::string& where) {
  std::string_view const text = trimmed(given);
  long value = 0;
  auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw InputError(fmt::format("{}: found \"{}\"; allowed: an integer", where, given));
  return value;
}

Table::Table(const toml::table& table, std::string file, std::string path)
    : table_(&table),
      file_(std::move(file)),
      path_(std::move(path)),
      read_(std::make_shared<std::set<std::string, std::less<>>>()),
      children_(std::make_shared<std::vector<Table>>()) {}

bool Table::has(std::string_view key) const { return table_->contains(key); }

bool Table::holdsTable(std::string_view key) const {
  const toml::node* node = table_->get(key);
  return node && node->is_table();
}

const toml::node* Table::find(std::string_view key) const {
  read_->emplace(key);
  return table_->get(key);
}

const toml::node& Table::required(std::string_view key) const {
  const toml::node* node = find(key);
  if (!node) fail(key, "missing; it is required");
  return *node;
}

std::string Table::where(std::string_view key) const {
  auto line = table_->source().begin.line;
  if (const toml::node* node = key.empty() ? nullptr : table_->get(key))
    line = node->source().begin.line;
  std::string text = line ? fmt::format("{}:{}", file_, line) : file_;
  if (!path_.empty()) text += fmt::format(": [{}]", path_);
  if (!key.empty()) text += fmt::format("{} {}", path_.empty() ? ":" : "", key);
  return text;
}

void Table::fail(std::string_view key, const std::string& message) const {
  throw InputError(where(key) + ": " + message);
}

std::string Table::textOf(std::string_view key, const char* wanted) const {
  const toml::node& node = required(key);
  if (!node.is_string()) fail(key, fmt::format("found {}; allowed: {}", kindOf(node), wanted));
  return node.as_string()->get();
}

std::string Table::text(std::string_view key) const { return textOf(key, "a string"); }

double Table::number(std::string_view key) const {
  const toml::node& node = required(key);
  auto const value = node.value<double>();
  if (!node.is_number() || !value)
    fail(key, fmt::format("found {}; allowed: a number", kindOf(node)));
  if (!std::isfinite(*value)) fail(key, "found a number that is not finite");
  return *value;
}

long Table::integer(std::string_view key) const {
  const toml::node& node = required(key);
  if (!node.is_integer()) fail(key, fmt::format("found {}; allowed: an integer", kindOf(node)));
  return static_cast<long>(node.as_integer()->get());
}

bool Table::boolean(std::string_view key) const {
  const toml::node& node = required(key);
  if (!node.is_boolean()) fail(key, fmt::format("found {}; allowed: true or false", kindOf(node)));
  return node.as_boolean()->get();
}

Length Table::length(std::string_view key) const {
  return parseLength(textOf(key, "a length with its unit, as in \"6378.137 km\""), where(key));
}
Angle Table::angle(std::string_view key) const {
  return parseAngle(textOf(key, "an angle with its unit, as in \"25.687 deg\""), where(key));
}
Duration Table::duration(std::string_view key) const {
  return parseDuration(textOf(key, "a time with its unit, as in \"5 min\""), where(key));
}

std::vector<double> Table::numbers(std::string_view key) const {
  const toml::node& node = required(key);
  if (!node.is_array())
    fail(key, fmt::format("found {}; allowed: an array of numbers", kindOf(node)));
  std::vector<double> values;
  for (auto const& element : *node.as_array()) {
    auto const value = element.value<double>();
    if (!element.is_number() || !value || !std::isfinite(*value))
      fail(key, fmt::format("element {} is not a finite number", values.size() + 1));
    values.push_back(*value);
  }
  return values;
}

std::vector<std::string> Table::texts(std::string_view key) const {
  const toml::node& node = required(key);
  if (!node.is_array())
    fail(key, fmt::format("found {}; allowed: an array of strings", kindOf(node)));
  std::vector<std::string> values;
  for (auto const& element : *node.as_array()) {
    if (!element.is_string())
      fail(key, fmt::format("element {} is not a string", values.size() + 1));
    values.push_back(element.as_string()->get());
  }
  return values;
}

std::string Table::oneOf(std::string_view key, const std::vector<std::string>& allowed) const {
  std::string const value = text(key);
  for (auto const& a : allowed)
    if (a == value) return value;
  fail(key, fmt::format("found \"{}\"; allowed: {}", value, fmt::join(allowed, ", ")));
}

std::string Table::text(std::string_view key, const std::string& otherwise) const {
  return find(key) ? text(key) : otherwise;
}
double Table::number(std::string_view key, double otherwise) const {
  return find(key) ? number(key) : otherwise;
}
long Table::integer(std::string_view key, long otherwise) const {
  return find(key) ? integer(key) : otherwise;
}
bool Table::boolean(std::string_view key, bool otherwise) const {
  return find(key) ? boolean(key) : otherwise;
}
Length Table::length(std::string_view key, Length otherwise) const {
  return find(key) ? length(key) : otherwise;
}
Angle Table::angle(std::string_view key, Angle otherwise) const {
  return find(key) ? angle(key) : otherwise;
}
Duration Table::duration(std::string_view key, Duration otherwise) const {
  return find(key) ? duration(key) : otherwise;
}

Table Table::table(std::string_view key) const {
  const toml::node& node = required(key);
  if (!node.is_table()) fail(key, fmt::format("found {}; allowed: a table", kindOf(node)));
  children_->emplace_back(*node.as_table(), file_,
                          path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key));
  return children_->back();
}

std::optional<Table> Table::tableIfPresent(std::string_view key) const {
  if (!find(key)) return std::nullopt;
  return table(key);
}

std::vector<Table> Table::tables(std::string_view key) const {
  std::vector<Table> result;
  const toml::node* node = find(key);
  if (!node) return result;
  if (!node->is_array_of_tables())
    fail(key, fmt::format("found {}; allowed: tables, as [[{}]]", kindOf(*node), key));
  for (auto const& element : *node->as_array()) {
    children_->emplace_back(*element.as_table(), file_,
                            path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key));
    result.push_back(children_->back());
  }
  return result;
}

std::vector<std::string> Table::keys() const {
  std::vector<std::string> result;
  for (auto const& [key, node] : *table_) {
    read_->emplace(key.str());
    result.emplace_back(key.str());
  }
  return result;
}

void Table::finish() const {
  for (auto const& [key, node] : *table_)
    if (!read_->contains(key.str()))
      fail(key.str(), fmt::format("unknown key; allowed here: {}", fmt::join(*read_, ", ")));
  for (auto const& child : *children_) child.finish();
}

Document Document::load(const std::filesystem::path& file) {
  std::ifstream stream;
  if (!std::filesystem::is_directory(file)) stream.open(file);
  if (!stream.is_open())
    throw InputError(fmt::format("{}: cannot be read; a TOML file was expected", file.string()));
  std::stringstream content;
  content << stream.rdbuf();
  return parse(content.str(), file.string());
}

Document Document::parse(std::string_view content, const std::string& name) {
  Document document;
  try {
    document.content_ = std::make_shared<toml::table>(toml::parse(content, name));
  } catch (const toml::parse_error& error) {
    throw InputError(fmt::format("{}:{}: {}", name, error.source().begin.line,
                                 std::string(error.description())));
  }
  document.root_ = std::make_shared<Table>(*document.content_, name, "");
  return document;
}

}  // namespace antumbra
