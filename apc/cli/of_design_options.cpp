#include <CLI/CLI.hpp>

#include "apc/cli/of_design.h"

namespace apc::cli {

void add_design_options(CLI::App& command, OfDesign& words, const std::string& out_help) {
  command.add_option("--design", words.design, "design.json of apc design")->type_name("FILE");
  command.add_option("--loads", words.choice.loads, "folder of load tables (default: the shipped ones)")
      ->type_name("DIR");
  command.add_option("--tires", words.choice.tires, "tire library")->type_name("FILE");
  command.add_option("--threads", words.threads, "default: all")->type_name("N");
  command.add_option("-o,--out", words.out, out_help)->type_name("DIR");
}

}  // namespace apc::cli
