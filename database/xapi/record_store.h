// SPDX-License-Identifier: GPL-3.0-or-later
// A learning record store (Experience API 1.0.3) over HTTP, and sending it what waits in the outbox. Blocks
// with an event loop of its own; needs a QCoreApplication.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "database/xapi/xapi_outbox.h"

namespace fulcrum::database {

/// What a request came to. `status` 0: no answer, `problem` says why.
struct RecordStoreAnswer {
    int status = 0;
    std::string body, problem;
    std::int64_t retry_after_ms = 0;  ///< as the answer asks; 0: it does not
};

/// Throws InputError unless it is an https address, or an http address of this machine.
std::string record_store_address(const std::string& address);

class RecordStore {
  public:
    /// `credentials`: "KEY:SECRET", sent as HTTP Basic; empty: none.
    RecordStore(const std::string& address, const std::string& credentials, int timeout_ms);
    ~RecordStore();
    RecordStore(const RecordStore&) = delete;
    RecordStore& operator=(const RecordStore&) = delete;
    RecordStoreAnswer send(const std::string& statement);
    /// Also one that was voided.
    RecordStoreAnswer fetch(const std::string& id);

  private:
    class Http;
    std::unique_ptr<Http> http_;
};

/// Whether the record store holds what we sent: it may add members, and write words and times in another way.
bool is_same_statement(const std::string& ours, const std::string& theirs);

struct SendResult {
    int sent = 0;          ///< taken now
    int known = 0;         ///< the record store had them already
    int quarantined = 0;   ///< refused, or another statement has the id
    int postponed = 0;     ///< no answer or an error of the record store: tried again later
    bool complete = true;  ///< false: stopped, or the record store could not be reached
};

/// Sends what waits and whose time has come, one by one; each result is stored before the next is sent, so
/// that it can be cut off anywhere. Gives up for now after three failures in a row. `stop`: asked before
/// each. Throws StoreError where the record store refuses the credentials or is none.
SendResult send_waiting(const XapiOutbox& outbox, RecordStore& record_store,
                        const std::function<bool()>& stop = {});

}  // namespace fulcrum::database
