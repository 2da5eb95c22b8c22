// SPDX-License-Identifier: GPL-3.0-or-later
// What a page reads of the store in the background, because it grows with attempts or people: the window
// answers while it is read. Of several requests the newest counts. UI thread.
#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

#include "database/store/store.h"
#include "ui/page/context.h"

namespace fulcrum::ui {

class BackgroundJob;

class StoreReading : public QObject {
    Q_OBJECT
  public:
    /// `part`: the page, or the part of one, that shows what is read; with it the reading ends.
    StoreReading(Context& context, QWidget* part);
    /// Only while signed in. `find` runs on a worker thread with a connection of its own, as who is signed in
    /// now; it must own what it touches. `show` then gets on the UI thread what it returned; if it threw, the
    /// message says why and `failed` is called with it. None of them after stop(), or for an older request.
    template <typename Find, typename Show>
    void begin(Find find, Show show, std::function<void(const QString&)> failed) {
        using Found = std::invoke_result_t<const Find&, const database::Store&, const database::Session&>;
        auto found = std::make_shared<std::optional<Found>>();
        start(
            [found, find = std::move(find)](const database::Store& store, const database::Session& session) {
                found->emplace(find(store, session));
            },
            [found, show = std::move(show)] { show(std::move(**found)); }, std::move(failed));
    }
    void stop();
    bool reads() const { return job_ != nullptr; }
    /// What was shown last was read in the role that who is signed in acts in.
    bool read_in_this_role() const { return read_as_ && *read_as_ == context_.session().role(); }

  private:
    void start(std::function<void(const database::Store&, const database::Session&)> find,
               std::function<void()> show, std::function<void(const QString&)> failed);

    Context& context_;
    BackgroundJob* job_ = nullptr;
    std::optional<database::Role> read_as_;
};

}  // namespace fulcrum::ui
