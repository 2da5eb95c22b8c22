// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/log_scanner.h"

#include <algorithm>
#include <utility>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr std::string_view xml_space = " \t\r\n";
constexpr std::size_t attribute_limit = 4096;  // bytes

bool is_name_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.' || c == ':';
}

/// The five entities that every XML has; others stay as they are.
std::string without_entities(std::string_view text) {
    constexpr std::pair<std::string_view, char> entities[] = {
        {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
    std::string plain;
    while (!text.empty()) {
        const auto found = std::find_if(std::begin(entities), std::end(entities), [&](const auto& entity) {
            return text.substr(0, entity.first.size()) == entity.first;
        });
        plain += found == std::end(entities) ? text.front() : found->second;
        text.remove_prefix(found == std::end(entities) ? 1 : found->first.size());
    }
    return plain;
}

}  // namespace

void LogScanner::fail(const Sentence& problem, const Sentence& hint) const {
    throw InputError(file_, std::to_string(element_line_), problem, hint);
}

const std::string& LogScanner::attribute(const LogElement& element, const char* name) const {
    const auto found = element.attributes.find(name);
    if (found == element.attributes.end())
        fail({QT_TRANSLATE_NOOP("errors", "<%1> has no attribute %2"), element.name, std::string(name)},
             QT_TRANSLATE_NOOP("errors", "record it again with PerkTutor, or remove this element"));
    return found->second;
}

void LogScanner::move(std::size_t to) {
    line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(place_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(to), '\n'));
    place_ = to;
}

void LogScanner::skip_to(std::string_view end) {
    const std::size_t found = text_.find(end, place_);
    if (found == std::string_view::npos)
        fail(QT_TRANSLATE_NOOP("errors", "the file ends within an element"),
             QT_TRANSLATE_NOOP("errors", "the recording was cut off: copy the file again"));
    move(found + end.size());
}

void LogScanner::skip_space() {
    move(std::min(text_.find_first_not_of(xml_space, place_), text_.size()));
}

void LogScanner::read_attribute(LogElement& element) {
    const std::size_t begin = place_;
    while (!is_at_end() && is_name_letter(text_[place_])) ++place_;
    const std::string name(text_.substr(begin, place_ - begin));
    skip_space();
    const bool has_value = !name.empty() && !is_at_end() && text_[place_] == '=';
    if (has_value) {
        ++place_;
        skip_space();
    }
    if (!has_value || is_at_end() || (text_[place_] != '"' && text_[place_] != '\''))
        fail({QT_TRANSLATE_NOOP("errors", "the attributes of <%1> cannot be read"), element.name},
             QT_TRANSLATE_NOOP("errors", "choose a recording that PerkTutor stored as XML"));
    const std::string_view quote = text_.substr(place_, 1);
    ++place_;
    const std::size_t from = place_;
    skip_to(quote);
    const std::string_view value = text_.substr(from, place_ - 1 - from);
    if (value.size() > attribute_limit)
        fail({QT_TRANSLATE_NOOP("errors", "attribute %1 has more than %2 bytes"), name, attribute_limit},
             QT_TRANSLATE_NOOP("errors", "choose a recording that PerkTutor stored as XML"));
    element.attributes[name] = without_entities(value);
}

bool LogScanner::next(LogElement& element) {
    for (;;) {
        const std::size_t found = text_.find('<', place_);
        if (found == std::string_view::npos) return false;
        move(found);
        element_line_ = line_;
        if (text_.substr(place_, 4) == "<!--") {
            skip_to("-->");
        } else if (text_.substr(place_, 2) == "<?" || text_.substr(place_, 2) == "<!") {
            skip_to(">");
        } else {
            break;
        }
    }
    ++place_;
    element = {};
    element.closes = !is_at_end() && text_[place_] == '/';
    if (element.closes) ++place_;
    const std::size_t begin = place_;
    while (!is_at_end() && is_name_letter(text_[place_])) ++place_;
    element.name = std::string(text_.substr(begin, place_ - begin));
    for (;;) {
        skip_space();
        if (is_at_end()) skip_to(">");  // says that it ends here
        if (text_[place_] == '>') break;
        if (text_[place_] == '/') {
            ++place_;
            continue;
        }
        read_attribute(element);
    }
    ++place_;
    return true;
}

}  // namespace fulcrum
