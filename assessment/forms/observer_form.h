// SPDX-License-Identifier: Apache-2.0
// A form with which a person who watches an attempt rates it: items with a scale and words for its points
// (assets/forms, docs/FORMATS.md). A rating never changes a score of the program.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace fulcrum {

/// What a rating of an item means.
struct FormAnchor {
    int rating = 0;
    std::string text;
};

struct FormItem {
    std::string id, title;
    int lowest = 1, highest = 5;      ///< the highest is the best
    bool optional = false;            ///< "not seen" is an answer
    std::vector<FormAnchor> anchors;  ///< by rising rating; the ends of the scale have one
};

struct ObserverForm {
    std::string id;
    int version = 1;
    std::string title, source;
    bool blind = true;  ///< neither name nor score nor other forms are seen before it is handed in
    std::vector<FormItem> items;
    std::string text;  ///< the file's content: it is stored with the ratings made with it

    /// "goals@1"
    std::string name() const { return id + "@" + std::to_string(version); }
    const FormItem* find(const std::string& item) const;
};

/// The answers to a form, an answer an item in the form's order; none: not seen, or not answered yet.
using FormAnswers = std::vector<std::optional<int>>;

/// Index of the first item that still needs an answer; none where the form can be handed in. `answered`:
/// which items have been answered, "not seen" included.
std::optional<std::size_t> first_unanswered(const ObserverForm& form, const FormAnswers& answers,
                                            const std::vector<bool>& answered);

/// Mean of the answers on the scale from 0 (all lowest) to 1 (all highest), so that items with other scales
/// weigh the same; none where nothing was seen. `answers` has one answer an item.
std::optional<double> form_share(const ObserverForm& form, const FormAnswers& answers);
/// Sum of the answers, and the lowest and highest sums of the items that were answered.
struct FormSum {
    int sum = 0, lowest = 0, highest = 0, answered = 0;
};
FormSum form_sum(const ObserverForm& form, const FormAnswers& answers);

/// Throws InputError with file, line, JSON pointer and hint.
ObserverForm parse_form(const std::string& text, const std::string& file);
ObserverForm load_form(const std::string& path);
/// Every form of a folder, by id, then version, both rising. None where there is no such folder. Throws
/// InputError also where two files have the same id and version.
std::vector<ObserverForm> load_forms(const std::string& folder);
/// Of those, the newest version of each id.
std::vector<ObserverForm> newest_forms(std::vector<ObserverForm> forms);

}  // namespace fulcrum
