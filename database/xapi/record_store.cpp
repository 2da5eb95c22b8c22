// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/xapi/record_store.h"

#include <QDateTime>
#include <QEventLoop>
#include <QHostAddress>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QNetworkAccessManager>
#include <QNetworkReply>
#include <QNetworkRequest>
#include <QUrl>
#include <QUrlQuery>
#include <memory>

#include "database/rows/errors.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum::database {
namespace {

constexpr int failures_in_a_row = 3;
constexpr qint64 longest_answer = 4 * 1024 * 1024;

bool is_this_machine(const QString& host) {
    return host == QLatin1String("localhost") || QHostAddress(host).isLoopback();
}

/// Every member of `ours` is in `theirs` with the same value, but for words to be read and for what a record
/// store may write in another way.
bool holds(const QJsonValue& theirs, const QJsonValue& ours, const QString& key = {}) {
    if (key == QLatin1String("display") || key == QLatin1String("definition") ||
        key == QLatin1String("version"))
        return true;
    if (key == QLatin1String("timestamp"))
        return QDateTime::fromString(ours.toString(), Qt::ISODateWithMs).toMSecsSinceEpoch() / 1000 ==
               QDateTime::fromString(theirs.toString(), Qt::ISODateWithMs).toMSecsSinceEpoch() / 1000;
    if (ours.isObject()) {
        const QJsonObject object = ours.toObject(), other = theirs.toObject();
        for (auto member = object.begin(); member != object.end(); ++member)
            if (!holds(other.value(member.key()), member.value(), member.key())) return false;
        return theirs.isObject();
    }
    if (ours.isArray()) {
        const QJsonArray list = ours.toArray(), other = theirs.toArray();
        if (list.size() != other.size()) return false;
        for (int i = 0; i < list.size(); ++i)
            if (!holds(other.at(i), list.at(i))) return false;
        return true;
    }
    return ours == theirs;
}

std::string answer_words(const RecordStoreAnswer& answer) {
    if (answer.status == 0) return answer.problem;
    const std::string body = QString::fromStdString(answer.body).simplified().left(200).toStdString();
    return "HTTP " + std::to_string(answer.status) + (body.empty() ? "" : ": " + body);
}

}  // namespace

std::string record_store_address(const std::string& address) {
    const QUrl url(QString::fromStdString(address), QUrl::StrictMode);
    const bool local = url.scheme() == QLatin1String("http") && is_this_machine(url.host());
    if (url.isValid() && !url.host().isEmpty() && url.userInfo().isEmpty() && !url.hasQuery() &&
        !url.hasFragment() && (url.scheme() == QLatin1String("https") || local))
        return address.back() == '/' ? address.substr(0, address.size() - 1) : address;
    throw InputError(QT_TRANSLATE_NOOP("errors", "command line"), "--to",
                     {QT_TRANSLATE_NOOP("errors", "\"%1\" is not the address of a record store"), address},
                     QT_TRANSLATE_NOOP("errors",
                                       "give its https address without credentials, such as "
                                       "https://lrs.example/xapi; http only on this machine"));
}

/// The requests, one at a time.
class RecordStore::Http {
  public:
    Http(const std::string& address, const std::string& credentials, int timeout_ms)
        : statements_(QString::fromStdString(record_store_address(address) + "/statements")),
          authorization_(credentials.empty()
                             ? QByteArray()
                             : QByteArray("Basic ") + QByteArray::fromStdString(credentials).toBase64()),
          timeout_ms_(timeout_ms) {}
    RecordStoreAnswer send(const std::string& statement) {
        return wait(manager_.post(request(statements_), QByteArray::fromStdString(statement)));
    }
    RecordStoreAnswer fetch_by(const char* parameter, const std::string& id) {
        QUrl url = statements_;
        QUrlQuery query;
        query.addQueryItem(QString::fromLatin1(parameter), QString::fromStdString(id));
        url.setQuery(query);
        return wait(manager_.get(request(url)));
    }

  private:
    QNetworkRequest request(const QUrl& url) const {
        QNetworkRequest made(url);
        made.setRawHeader("X-Experience-API-Version", "1.0.3");
        made.setHeader(QNetworkRequest::ContentTypeHeader, QByteArray("application/json"));
        if (!authorization_.isEmpty()) made.setRawHeader("Authorization", authorization_);
        // Credentials go to the address that was given, and nowhere else.
        made.setAttribute(QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
        made.setTransferTimeout(timeout_ms_);
        return made;
    }
    static RecordStoreAnswer wait(QNetworkReply* reply) {
        const std::unique_ptr<QNetworkReply> owned(reply);
        reply->setReadBufferSize(longest_answer);
        QEventLoop loop;
        QObject::connect(reply, &QNetworkReply::finished, &loop, &QEventLoop::quit);
        if (!reply->isFinished()) loop.exec();
        RecordStoreAnswer answer;
        answer.status = reply->attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
        // The status came, but not the whole answer: as if there were none.
        const QNetworkReply::NetworkError error = reply->error();
        const bool cut_off =
            error == QNetworkReply::OperationCanceledError || error == QNetworkReply::RemoteHostClosedError;
        if (answer.status == 0 || cut_off) {
            answer.status = 0;
            answer.problem = reply->errorString().toStdString();
            return answer;
        }
        answer.body = reply->read(longest_answer).toStdString();
        bool whole = false;
        const int seconds = reply->rawHeader("Retry-After").toInt(&whole);
        if (whole && seconds > 0) answer.retry_after_ms = std::int64_t{1000} * seconds;
        return answer;
    }

    QUrl statements_;
    QByteArray authorization_;
    int timeout_ms_;
    QNetworkAccessManager manager_;
};

RecordStore::RecordStore(const std::string& address, const std::string& credentials, int timeout_ms)
    : http_(std::make_unique<Http>(address, credentials, timeout_ms)) {}
RecordStore::~RecordStore() = default;

RecordStoreAnswer RecordStore::send(const std::string& statement) {
    return http_->send(statement);
}

RecordStoreAnswer RecordStore::fetch(const std::string& id) {
    const RecordStoreAnswer answer = http_->fetch_by("statementId", id);
    return answer.status == 404 ? http_->fetch_by("voidedStatementId", id) : answer;
}

bool is_same_statement(const std::string& ours, const std::string& theirs) {
    const QJsonDocument mine = QJsonDocument::fromJson(QByteArray::fromStdString(ours)),
                        found = QJsonDocument::fromJson(QByteArray::fromStdString(theirs));
    return mine.isObject() && found.isObject() && holds(found.object(), mine.object());
}

SendResult send_waiting(const XapiOutbox& outbox, RecordStore& record_store,
                        const std::function<bool()>& stop) {
    SendResult result;
    int failures = 0;
    while (const std::optional<OutboxStatement> next = outbox.next()) {
        if (failures >= failures_in_a_row || (stop && stop())) {
            result.complete = false;
            break;
        }
        RecordStoreAnswer answer = record_store.send(next->text);
        bool known = false, differs = false;
        if (answer.status == 409) {
            answer = record_store.fetch(next->id);
            known = answer.status == 200 && is_same_statement(next->text, answer.body);
            differs = answer.status == 200 && !known;
        }
        if (answer.status == 401 || answer.status == 403)
            throw StoreError(StoreErrorKind::failed,
                             QT_TRANSLATE_NOOP("errors", "the record store refuses the credentials"),
                             QT_TRANSLATE_NOOP("errors", "correct the file; what waits is kept"));
        if (differs) {
            outbox.quarantine(next->id, "the record store has another statement with this id");
            ++result.quarantined;
            failures = 0;
        } else if (answer.status == 200 || answer.status == 204) {
            outbox.finish(next->id);
            ++(known ? result.known : result.sent);
            failures = 0;
        } else if (answer.status == 400 || answer.status == 413) {
            outbox.quarantine(next->id, answer_words(answer));
            ++result.quarantined;
            failures = 0;
        } else {
            outbox.postpone(next->id, answer_words(answer), answer.retry_after_ms);
            ++result.postponed;
            // 429: it asks for less.
            failures = answer.status == 429 ? failures_in_a_row : failures + 1;
        }
    }
    return result;
}

}  // namespace fulcrum::database
