#include "framework/apps/check_options.h"

namespace luch {

void CheckArguments::declare(Arguments& arguments) {
    arguments.positional("TOPIC", topic, "the homework's folder: vista");
    arguments.option("--task", task, "ID", "only this task or test: vista.t3 [all]");
    arguments.option("--seed", seed, "N", "also on scenes made from this number");
    arguments.option("--json", json, "FILE", "write report.json, again after every test");
    arguments.flag("--mutants", mutants, "check the tests: every known mistake must be found");
    arguments.flag("--variants", variants, "check the tests: every honest solution must pass");
    arguments.flag("--regenerate", regenerate,
                   "say which stored reference outputs would change, and show it (FLIP); "
                   "with --yes, write them");
    arguments.flag("--handout", handout, "make the pictures of the handout again");
    arguments.flag("--yes", yes, "with --regenerate: overwrite");
}

std::string_view CheckArguments::examples() {
    return "  luch check vista                     builds homework/vista and checks it\n"
           "  luch check vista --task vista.t3     only one task\n"
           "  luch check vista --seed 7            also on three scenes that nobody has seen\n"
           "  luch check vista --json report.json  for a machine to read\n"
           "  luch check --mutants vista           are all known mistakes found?\n"
           "  luch check vista --regenerate        would the reference outputs change?\n"
           "  luch check vista --handout           the handout's pictures, "
           "homework/vista/pictures\n";
}

}  // namespace luch
