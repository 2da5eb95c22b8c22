// SPDX-License-Identifier: GPL-3.0-or-later
// JSON written from front to back, without a document in memory: for exports of a hundred thousand values.
// The text is that of nlohmann::ordered_json::dump() for the same members. Internal to this room.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::ui {

class JsonText {
  public:
    JsonText& begin_object() { return open('{'); }
    JsonText& end_object() { return close('}'); }
    JsonText& begin_array() { return open('['); }
    JsonText& end_array() { return close(']'); }
    /// The name of a member: its value follows. A name of ours, which needs no escaping.
    JsonText& key(std::string_view name) {
        separate();
        text_ += '"';
        text_ += name;
        text_ += "\":";
        first_ = true;
        return *this;
    }
    JsonText& value(std::string_view text) {
        separate();
        bool plain = true;
        for (const char c : text) plain = plain && c >= 0x20 && c < 0x7f && c != '"' && c != '\\';
        if (!plain) {
            text_ += nlohmann::ordered_json(text).dump();
        } else {
            text_ += '"';
            text_ += text;
            text_ += '"';
        }
        return *this;
    }
    JsonText& value(const char* text) { return value(std::string_view(text)); }
    JsonText& value(const std::string& text) { return value(std::string_view(text)); }
    JsonText& value(double number) { return raw(nlohmann::ordered_json(number).dump()); }
    JsonText& value(int number) { return raw(std::to_string(number)); }
    JsonText& value(bool flag) { return raw(flag ? "true" : "false"); }
    JsonText& null() { return raw("null"); }
    template <typename T>
    JsonText& value(const std::optional<T>& one) {
        return one ? value(*one) : null();
    }
    /// JSON as it is.
    JsonText& raw(std::string_view json) {
        separate();
        text_ += json;
        return *this;
    }
    template <typename T>
    JsonText& member(std::string_view name, const T& one) {
        return key(name).value(one);
    }
    /// Null where it is empty.
    JsonText& member_or_null(std::string_view name, const std::string& one) {
        key(name);
        return one.empty() ? null() : value(one);
    }

    const std::string& text() const noexcept { return text_; }
    std::string take() {
        first_ = true;
        return std::move(text_);
    }

  private:
    JsonText& open(char bracket) {
        separate();
        text_ += bracket;
        first_ = true;
        return *this;
    }
    JsonText& close(char bracket) {
        text_ += bracket;
        first_ = false;
        return *this;
    }
    void separate() {
        if (!first_) text_ += ',';
        first_ = false;
    }
    std::string text_;
    bool first_ = true;  ///< no comma before what comes next
};

}  // namespace fulcrum::ui
