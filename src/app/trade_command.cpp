// `antumbra trade`: error against cost, one subject per subcommand.
#include "app/commands.h"

namespace antumbra {

void addTradeCommand(CLI::App& program) {
  auto* trade = program.add_subcommand("trade", "Error against cost of what can be chosen");
  trade->require_subcommand(1);
  addTradeEphemeris(*trade);
  addTradeSky(*trade);
  addTradeTotality(*trade);
  addTradeShadows(*trade);
}

}  // namespace antumbra
