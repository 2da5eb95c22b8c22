// SPDX-License-Identifier: GPL-3.0-or-later
// fulcrum forms: the installed observer forms, with their items and scales.
#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "assessment/assets/assets.h"
#include "assessment/forms/observer_form.h"

namespace fulcrum::app {
namespace {

nlohmann::json to_json(const ObserverForm& form) {
    nlohmann::json items = nlohmann::json::array();
    for (const FormItem& item : form.items) {
        nlohmann::json anchors = nlohmann::json::array();
        for (const FormAnchor& anchor : item.anchors)
            anchors.push_back({{"rating", anchor.rating}, {"text", anchor.text}});
        items.push_back({{"id", item.id},
                         {"title", item.title},
                         {"lowest", item.lowest},
                         {"highest", item.highest},
                         {"optional", item.optional},
                         {"anchors", anchors}});
    }
    return {{"form", form.name()},
            {"title", form.title},
            {"source", form.source},
            {"blind", form.blind},
            {"items", items}};
}

int run_forms(const Arguments& arguments) {
    nlohmann::json forms = nlohmann::json::array();
    for (const ObserverForm& form : load_forms(asset_path("forms"))) {
        forms.push_back(to_json(form));
        if (arguments.has("--json")) continue;
        std::cout << form.name() << "  " << form.title << ", " << form.items.size() << " items"
                  << (form.blind ? ", blind" : "") << "\n    " << form.source << '\n';
        for (const FormItem& item : form.items)
            std::cout << "    " << item.title << ", " << item.lowest << " to " << item.highest
                      << (item.optional ? ", or not seen" : "") << '\n';
    }
    if (arguments.has("--json")) print_json({{"forms", forms}});
    return 0;
}

}  // namespace

Command forms_command() {
    return {"forms",
            "",
            0,
            0,
            QT_TRANSLATE_NOOP(
                "commands",
                "Lists the installed observer forms with their items; fulcrum check FILE checks one."),
            {json_option()},
            run_forms};
}

}  // namespace fulcrum::app
