// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/statement.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "assessment/metrics/statement_words.h"

namespace fulcrum {

using Json = nlohmann::ordered_json;

namespace {

template <typename Value>
const Value* parameter(const Statement& statement, std::string_view name) {
    for (const Parameter& one : statement.parameters())
        if (one.name == name) return std::get_if<Value>(&one.value);
    return nullptr;
}

Json value_json(const Parameter& parameter) {
    if (const auto* number = std::get_if<double>(&parameter.value)) return *number;
    if (const auto* text = std::get_if<std::string>(&parameter.value)) return *text;
    return statement_json(std::get<Statement>(parameter.value));
}

}  // namespace

Statement::Statement() = default;
Statement::Statement(StatementId id) : id_(id) {}
Statement::Statement(StatementId id, std::initializer_list<Parameter> parameters)
    : id_(id), parameters_(parameters) {
    sort();
}

Statement Statement::plain(std::string text) {
    if (text.empty()) return {};
    return {StatementId::plain, {{"text", std::move(text)}}};
}

void Statement::add(Parameter parameter) {
    parameters_.push_back(std::move(parameter));
    sort();
}

void Statement::sort() {
    std::sort(parameters_.begin(), parameters_.end(),
              [](const Parameter& a, const Parameter& b) { return a.name < b.name; });
}

const double* Statement::number(std::string_view name) const {
    return parameter<double>(*this, name);
}
const std::string* Statement::text(std::string_view name) const {
    return parameter<std::string>(*this, name);
}
const Statement* Statement::statement(std::string_view name) const {
    return parameter<Statement>(*this, name);
}

bool operator==(const Statement& a, const Statement& b) {
    return stored_text(a) == stored_text(b);
}
bool operator!=(const Statement& a, const Statement& b) {
    return !(a == b);
}

/// Plain for what this program does not know.
Statement statement_from_json(const Json& node) {
    const auto not_known = [&] {
        return Statement::plain(node.is_string() ? node.get<std::string>() : node.dump());
    };
    if (!node.is_object() || !node.contains("id") || !node.at("id").is_string()) return not_known();
    const StatementRow* row = find_row(statements, node.at("id").get<std::string>());
    if (row == nullptr || row->kind == StatementId::none || row->kind == StatementId::plain)
        return not_known();
    Statement statement(row->kind);
    for (const auto& [name, value] : node.items()) {
        if (name == "id") continue;
        if (value.is_number())
            statement.parameters_.emplace_back(name, value.get<double>());
        else if (value.is_string())
            statement.parameters_.emplace_back(name, value.get<std::string>());
        else {
            Statement part = statement_from_json(value);
            if (part.id() == StatementId::plain) return not_known();
            statement.parameters_.emplace_back(name, std::move(part));
        }
    }
    statement.sort();
    return statement;
}

Json statement_json(const Statement& statement) {
    if (statement.empty()) return nullptr;
    // A part of a statement may be a sentence from an old store.
    if (statement.id() == StatementId::plain) return nullptr;
    Json node = {{"id", row_of(statements, statement.id()).name}};
    for (const Parameter& parameter : statement.parameters()) {
        const auto* part = std::get_if<Statement>(&parameter.value);
        const bool plain = part != nullptr && part->id() == StatementId::plain;
        node[parameter.name] = plain ? Json(*part->text("text")) : value_json(parameter);
    }
    return node;
}

std::string stored_text(const Statement& statement) {
    if (statement.empty()) return {};
    if (statement.id() == StatementId::plain) return *statement.text("text");
    return statement_json(statement).dump(-1, ' ', false, Json::error_handler_t::replace);
}

Statement statement_of(const std::string& stored) {
    if (stored.empty() || stored.front() != '{') return Statement::plain(stored);
    const Json node = Json::parse(stored, nullptr, false);
    if (node.is_discarded()) return Statement::plain(stored);
    Statement statement = statement_from_json(node);
    return statement.id() == StatementId::plain ? Statement::plain(stored) : statement;
}

}  // namespace fulcrum
