// Options that all eclipse commands share: the convention and each of its constants, and delta T.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "eclipse/eclipse_search.h"

namespace antumbra {

struct EclipseOptions {
  std::string convention = "nasa";
  std::string sunRadius, deltaT, enlargement;
  std::string kUmbra, kPenumbra;

  void addTo(CLI::App& command);
  // Throws InputError naming the option.
  EclipseBasis basis() const;
};

// What a command about one eclipse takes: its date, how and where to write it, and the above.
struct DatedEclipseOptions {
  std::string date, format, output;
  EclipseOptions shared;

  // The first of `formats` is the default.
  void addTo(CLI::App& command, const std::vector<std::string>& formats);
};

// "convention nasa: Sun 695989.8 km, Moon k 0.272281 (umbra) 0.272488 (penumbra), ..."
std::string describe(const EclipseBasis& basis);

// "5min", "30 s", "1 h", "0.5 min": a positive duration.
Duration parseStep(const std::string& text, const std::string& where);

void addEclipseList(CLI::App& eclipse);
void addEclipseAt(CLI::App& eclipse);
void addEclipsePath(CLI::App& eclipse);
void addEclipseMap(CLI::App& eclipse);
void addEclipseElements(CLI::App& eclipse);

}  // namespace antumbra
