// SPDX-License-Identifier: Apache-2.0
// The functions of a C++ source and their lengths, for tests that check its structure.
#pragma once

#include <algorithm>
#include <cctype>
#include <regex>
#include <string>
#include <vector>

#include "tests/structure/sources.h"

namespace fulcrum::structure {

/// A function that is not inside another one; its lambdas and local types count as its lines.
struct Function {
    std::string head;  // what is written before its body, in one line
    int line = 0;      // of the head, from 1
    int lines = 0;     // head and body
    bool has_reason = false;
};

struct Functions {
    std::vector<Function> found;
    bool balanced = true;  // every brace has its partner; else the lengths mean nothing
};

/// The source with comments, texts, characters and preprocessor lines blanked, line by line as before.
inline std::string code_of(const std::string& text) {
    std::string code = text;
    std::size_t i = 0;
    const auto blank_to = [&](std::size_t end) {
        for (end = std::min(end, code.size()); i < end; ++i)
            if (code[i] != '\n') code[i] = ' ';
    };
    // The end of a line that backslashes continue.
    const auto end_of_line = [&](std::size_t from) {
        std::size_t end = text.find('\n', from);
        while (end != std::string::npos && end > 0 && text[end - 1] == '\\') end = text.find('\n', end + 1);
        return end;
    };
    const auto end_of_literal = [&](std::size_t from, char quote) {
        std::size_t end = from;
        while (end < text.size() && text[end] != quote) end += text[end] == '\\' ? 2U : 1U;
        return end + 1;
    };
    bool line_is_empty = true;
    while (i < text.size()) {
        const char c = text[i];
        if (c == '\n') {
            line_is_empty = true;
            ++i;
        } else if (text.compare(i, 2, "//") == 0 || (c == '#' && line_is_empty)) {
            blank_to(end_of_line(i));
        } else if (text.compare(i, 2, "/*") == 0) {
            const std::size_t end = text.find("*/", i + 2);
            blank_to(end == std::string::npos ? end : end + 2);
        } else if (text.compare(i, 2, "R\"") == 0) {
            const std::size_t open = text.find('(', i);
            const std::string close = ")" + text.substr(i + 2, open - i - 2) + "\"";
            blank_to(text.find(close, open) + close.size());
            line_is_empty = false;
        } else if (c == '"') {
            blank_to(end_of_literal(i + 1, '"'));
            line_is_empty = false;
        } else if (c == '\'' && (i == 0 || std::isalnum(static_cast<unsigned char>(text[i - 1])) == 0)) {
            blank_to(end_of_literal(i + 1, '\''));
            line_is_empty = false;
        } else {
            line_is_empty = line_is_empty && std::isspace(static_cast<unsigned char>(c)) != 0;
            ++i;
        }
    }
    return code;
}

/// What a brace opens.
enum class Opens { function, block, scope, values };

/// What the brace after this head opens: the head is what was written since the statement began.
inline Opens what_opens(const std::string& head) {
    static const std::regex lambda(
        R"((^|[^\w\])\s])\s*\[[^\[\]]*\]\s*(\((?:[^()]|\([^()]*\))*\))?\s*(mutable|noexcept|\s)*(->[^;{}()=]*)?$)");
    static const std::regex returned_lambda(
        R"(\breturn\s*\[[^\[\]]*\]\s*(\((?:[^()]|\([^()]*\))*\))?\s*(mutable|noexcept|\s)*(->[^;{}()=]*)?$)");
    static const std::regex control(R"(^(else|do|try|(else\s+)?if|for|while|switch|catch)\b)");
    static const std::regex label(R"(^(case\b.*|default\s*|\w+\s*):$)");
    static const std::regex after_parameters(
        R"(\)\s*(const|noexcept(\s*\(.*\))?|override|final|volatile|&|\s)*(->[^;{}()=]*)?$)");
    static const std::regex initialised(R"(\)[^?]*[^:]:[^:].*\}$)");
    static const std::regex type(R"(\b(namespace|struct|class|enum|union|extern)\b)");
    // Most heads lack the character that a pattern needs, and searching them takes long.
    const bool has_bracket = head.find('[') != std::string::npos;
    if (has_bracket && (std::regex_search(head, lambda) || std::regex_search(head, returned_lambda)))
        return Opens::function;
    if (head.empty() || std::regex_search(head, control) || std::regex_match(head, label))
        return Opens::block;
    const bool has_parameters = head.find(')') != std::string::npos;
    if (has_parameters && (std::regex_search(head, after_parameters) ||
                           (head.back() == '}' && std::regex_search(head, initialised))))
        return Opens::function;
    return std::regex_search(head, type) ? Opens::scope : Opens::values;
}

/// Whether the comment directly above a line (from 1) gives a reason for a long function.
inline bool has_reason_above(const std::vector<std::string>& lines, int line) {
    static const std::regex comment(R"(^\s*//.*)"), reason(R"(^\s*///? Long because: \S.*)");
    for (int above = line - 1; above > 0; --above) {
        const std::string& text = lines[static_cast<std::size_t>(above - 1)];
        if (!std::regex_match(text, comment)) return false;
        if (std::regex_match(text, reason)) return true;
    }
    return false;
}

inline Functions functions_of(const std::string& text) {
    static const std::regex access(
        R"(\b(public|private|protected|signals|Q_SIGNALS)(\s+(slots|Q_SLOTS))?\s*$)");
    struct Open {
        Opens what;
        std::size_t function;  // index in what was found; none outside
        int parentheses;
    };
    const std::size_t none = static_cast<std::size_t>(-1);
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string each; std::getline(stream, each);) lines.push_back(each);

    Functions result;
    std::vector<Open> open;
    std::string head;
    int line = 1, head_line = 1, parentheses = 0;
    const auto inside = [&] { return open.empty() ? none : open.back().function; };
    const auto trimmed = [](const std::string& s) {
        const std::size_t end = s.find_last_not_of(' ');
        return end == std::string::npos ? std::string() : s.substr(0, end + 1);
    };
    const std::string code = code_of(text);
    for (std::size_t i = 0; i < code.size(); ++i) {
        const char c = code[i];
        if (c == '\n') ++line;
        if (c == '{') {
            const std::string before = trimmed(head);
            std::size_t function = inside();
            // Within a function nothing else is looked for.
            const Opens what = function == none ? what_opens(before) : Opens::block;
            if (what == Opens::function && function == none) {
                function = result.found.size();
                result.found.push_back({before, head_line, 0, has_reason_above(lines, head_line)});
            }
            open.push_back({what, function, parentheses});
            head = what == Opens::values ? head + c : std::string();
            if (what != Opens::values) parentheses = 0;
            continue;
        }
        if (c == '}') {
            if (open.empty()) {
                result.balanced = false;
                return result;
            }
            const Open closed = open.back();
            open.pop_back();
            if (closed.function != none && inside() == none) {
                Function& function = result.found[closed.function];
                function.lines = line - function.line + 1;
            }
            parentheses = closed.parentheses;
            head = closed.what == Opens::values ? head + c : std::string();
            continue;
        }
        if (c == '(') ++parentheses;
        if (c == ')') --parentheses;
        const bool ends_access = c == ':' && inside() == none && std::regex_search(head, access);
        if ((c == ';' && parentheses <= 0) || ends_access) {
            head.clear();
        } else if (std::isspace(static_cast<unsigned char>(c)) == 0) {
            if (head.empty()) head_line = line;
            head += c;
        } else if (!head.empty() && head.back() != ' ') {
            head += ' ';
        }
    }
    result.balanced = open.empty();
    return result;
}

}  // namespace fulcrum::structure
