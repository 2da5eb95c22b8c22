// SPDX-License-Identifier: GPL-3.0-or-later
// A learning record store for tests: an HTTP server on the loopback that keeps statements by their id and
// answers as the specification says, or as a test wants.
#pragma once

#include <QCoreApplication>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>
#include <QUrl>
#include <QUrlQuery>
#include <QtNetwork/QHostAddress>
#include <QtNetwork/QTcpServer>
#include <QtNetwork/QTcpSocket>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace fulcrum::database::test {

struct HttpRequest {
    std::string method, target, body;
    std::map<std::string, std::string> headers;  ///< names in small letters
};

class FakeRecordStore {
  public:
    FakeRecordStore() {
        QObject::connect(&server_, &QTcpServer::newConnection, &server_, [this] {
            while (QTcpSocket* socket = server_.nextPendingConnection()) {
                QObject::connect(socket, &QTcpSocket::readyRead, socket, [this, socket] { read(socket); });
                QObject::connect(socket, &QTcpSocket::disconnected, socket, [this, socket] {
                    pending_.erase(socket);
                    socket->deleteLater();
                });
            }
        });
        server_.listen(QHostAddress::LocalHost);
    }
    std::string address() const {
        return "http://127.0.0.1:" + std::to_string(server_.serverPort()) + "/xapi";
    }
    int port() const { return server_.serverPort(); }

    /// Status to answer instead; 0: as usual; -1: never; -2: keep the statement, then never; -3: cut off.
    std::function<int(const HttpRequest&)> instead = [](const HttpRequest&) { return 0; };
    std::string words;                              ///< body of an answer with another status
    std::string extra;                              ///< further headers, each with its line end
    std::map<std::string, std::string> statements;  ///< by id
    std::vector<HttpRequest> requests;

  private:
    void read(QTcpSocket* socket) {
        QByteArray& bytes = pending_[socket];
        bytes += socket->readAll();
        for (;;) {
            const int head = bytes.indexOf("\r\n\r\n");
            if (head < 0) return;
            HttpRequest request;
            const QList<QByteArray> lines = bytes.left(head).split('\n');
            request.method = lines[0].split(' ').value(0).toStdString();
            request.target = lines[0].split(' ').value(1).toStdString();
            for (int i = 1; i < lines.size(); ++i) {
                const int colon = lines[i].indexOf(':');
                request.headers[lines[i].left(colon).trimmed().toLower().toStdString()] =
                    lines[i].mid(colon + 1).trimmed().toStdString();
            }
            const int length = QByteArray::fromStdString(request.headers["content-length"]).toInt();
            if (bytes.size() < head + 4 + length) return;
            request.body = bytes.mid(head + 4, length).toStdString();
            bytes.remove(0, head + 4 + length);
            requests.push_back(request);
            answer(socket, request);
            if (pending_.count(socket) == 0) return;
        }
    }
    void answer(QTcpSocket* socket, const HttpRequest& request) {
        const int wanted = instead(request);
        if (wanted == -3) return socket->abort();
        if (wanted == -1) return;
        if (wanted > 0) return write(socket, wanted, words);
        const std::string id = QJsonDocument::fromJson(QByteArray::fromStdString(request.body))
                                   .object()
                                   .value(QLatin1String("id"))
                                   .toString()
                                   .toStdString();
        if (request.method == "GET") {
            const QUrlQuery query(QUrl(QString::fromStdString(request.target)));
            const auto found =
                statements.find(query.queryItemValue(QStringLiteral("statementId")).toStdString());
            if (found == statements.end()) return write(socket, 404, "");
            return write(socket, 200, found->second);
        }
        if (statements.count(id) != 0) return write(socket, 409, "known");
        statements[id] = request.body;
        if (wanted != -2) write(socket, 200, "[\"" + id + "\"]");
    }
    void write(QTcpSocket* socket, int status, const std::string& body) const {
        socket->write(QByteArray::fromStdString(
            "HTTP/1.1 " + std::to_string(status) + " Answer\r\nContent-Type: application/json\r\n" + extra +
            "Content-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body));
        socket->flush();
    }
    std::map<QTcpSocket*, QByteArray> pending_;
    QTcpServer server_;  // ends first: its sockets report that they are closed
};

}  // namespace fulcrum::database::test
