// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum lab experiment: runs the experiments of assets/experiments and writes their pages and pictures.
#include "app/lab/experiment.h"
#include "app/lab/pages.h"

namespace fulcrum::app {

int run_experiments(const Arguments& arguments) {
    if (!arguments.has("--output"))
        throw UsageError("--output", "is missing", "name the folder for pages and pictures: --output FOLDER");
    const std::vector<std::string> files = arguments.words().empty() ? experiment_files() : arguments.words();
    make_output(arguments);
    for (const std::string& file : files) deliver(arguments, experiment_page(file), {});
    return 0;
}

}  // namespace fulcrum::app
