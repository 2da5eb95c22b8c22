// SPDX-License-Identifier: Apache-2.0
#include "assessment/forms/observer_form.h"

#include <algorithm>
#include <filesystem>
#include <tuple>

#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {

extern const char* const form_schema_text;  // assets/schemas/form.schema.json, embedded

namespace {

using nlohmann::json;

std::string place(std::size_t item, const std::string& rest) {
    return "/items/" + std::to_string(item) + rest;
}

void check_anchors(const JsonDocument& document, std::size_t number, const FormItem& item) {
    for (std::size_t i = 0; i < item.anchors.size(); ++i) {
        const int rating = item.anchors[i].rating;
        const std::string where = place(number, "/anchors/" + std::to_string(i) + "/rating");
        if (rating < item.lowest || rating > item.highest)
            document.fail(
                where, {QT_TRANSLATE_NOOP("errors", "is outside the scale of the item (is %1)"), rating},
                {QT_TRANSLATE_NOOP("errors", "use a rating from %1 to %2"), item.lowest, item.highest});
        if (i > 0 && rating <= item.anchors[i - 1].rating)
            document.fail(
                where, {QT_TRANSLATE_NOOP("errors", "does not follow the anchor before it (is %1)"), rating},
                QT_TRANSLATE_NOOP("errors", "list the anchors by rising rating, each rating once"));
    }
    if (item.anchors.front().rating != item.lowest || item.anchors.back().rating != item.highest)
        document.fail(
            place(number, "/anchors"),
            QT_TRANSLATE_NOOP("errors", "leaves an end of the scale without words"),
            {QT_TRANSLATE_NOOP("errors", "describe the ratings %1 and %2"), item.lowest, item.highest});
}

FormItem read_item(const JsonDocument& document, std::size_t number, const json& node) {
    FormItem item;
    item.id = node.at("id").get<std::string>();
    item.title = node.at("title").get<std::string>();
    item.lowest = node.at("lowest").get<int>();
    item.highest = node.at("highest").get<int>();
    if (item.highest <= item.lowest)
        document.fail(place(number, "/highest"),
                      {QT_TRANSLATE_NOOP("errors", "must be above /lowest (is %1)"), item.highest},
                      QT_TRANSLATE_NOOP("errors", "give the scale at least two ratings"));
    if (node.contains("optional")) item.optional = node.at("optional").get<bool>();
    for (const json& anchor : node.at("anchors"))
        item.anchors.push_back({anchor.at("rating").get<int>(), anchor.at("text").get<std::string>()});
    check_anchors(document, number, item);
    return item;
}

}  // namespace

const FormItem* ObserverForm::find(const std::string& item) const {
    const auto found =
        std::find_if(items.begin(), items.end(), [&](const FormItem& one) { return one.id == item; });
    return found == items.end() ? nullptr : &*found;
}

std::optional<std::size_t> first_unanswered(const ObserverForm& form, const FormAnswers& answers,
                                            const std::vector<bool>& answered) {
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        if (!answered.at(i) || (!answers.at(i) && !form.items[i].optional)) return i;
    }
    return std::nullopt;
}

std::optional<double> form_share(const ObserverForm& form, const FormAnswers& answers) {
    double sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        if (!answers.at(i)) continue;
        const FormItem& item = form.items[i];
        sum += static_cast<double>(*answers[i] - item.lowest) / (item.highest - item.lowest);
        ++count;
    }
    if (count == 0) return std::nullopt;
    return sum / count;
}

FormSum form_sum(const ObserverForm& form, const FormAnswers& answers) {
    FormSum result;
    for (std::size_t i = 0; i < form.items.size(); ++i) {
        if (!answers.at(i)) continue;
        result.sum += *answers[i];
        result.lowest += form.items[i].lowest;
        result.highest += form.items[i].highest;
        ++result.answered;
    }
    return result;
}

ObserverForm parse_form(const std::string& text, const std::string& file) {
    const JsonDocument document = JsonDocument::parse(text, file);
    document.check_schema(form_schema_text);
    const json& root = document.root();
    ObserverForm form;
    form.id = root.at("id").get<std::string>();
    form.version = root.at("version").get<int>();
    form.title = root.at("title").get<std::string>();
    form.source = root.at("source").get<std::string>();
    form.blind = root.at("blind").get<bool>();
    form.text = text;
    for (const json& node : root.at("items")) {
        FormItem item = read_item(document, form.items.size(), node);
        if (form.find(item.id) != nullptr)
            document.fail(place(form.items.size(), "/id"),
                          {QT_TRANSLATE_NOOP("errors", "%1 is listed twice"), item.id},
                          QT_TRANSLATE_NOOP("errors", "give every item its own id"));
        form.items.push_back(std::move(item));
    }
    return form;
}

ObserverForm load_form(const std::string& path) {
    return parse_form(read_text_file(path, JsonLimits().bytes), path);
}

std::vector<ObserverForm> load_forms(const std::string& folder) {
    std::vector<ObserverForm> forms;
    if (!std::filesystem::is_directory(folder)) return forms;
    std::vector<std::string> paths;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".json") paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    for (const std::string& path : paths) {
        ObserverForm form = load_form(path);
        for (const ObserverForm& other : forms)
            if (other.name() == form.name())
                throw InputError(
                    path, "/version",
                    {QT_TRANSLATE_NOOP("errors", "another form has the same id and version: %1"), form.id},
                    QT_TRANSLATE_NOOP("errors",
                                      "raise the version of the changed file, or give it an id of its own"));
        forms.push_back(std::move(form));
    }
    std::sort(forms.begin(), forms.end(), [](const ObserverForm& a, const ObserverForm& b) {
        return std::tie(a.id, a.version) < std::tie(b.id, b.version);
    });
    return forms;
}

std::vector<ObserverForm> newest_forms(std::vector<ObserverForm> forms) {
    std::vector<ObserverForm> newest;
    for (ObserverForm& form : forms) {
        if (!newest.empty() && newest.back().id == form.id) newest.pop_back();
        newest.push_back(std::move(form));
    }
    return newest;
}

}  // namespace fulcrum
