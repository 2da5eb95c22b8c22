// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language/linguist_file.h"

#include <QFile>
#include <QXmlStreamReader>
#include <map>
#include <mutex>
#include <stdexcept>

namespace fulcrum::ui {
namespace {

QByteArray key(const QByteArray& context, const QByteArray& source) {
    return context + '\0' + source;
}

/// The forms of the <translation> that the reader is at; none for an unfinished one.
QStringList forms_of(QXmlStreamReader& xml) {
    const bool unfinished = xml.attributes().hasAttribute(QLatin1String("type"));
    QStringList forms;
    QString text;
    while (xml.readNext() != QXmlStreamReader::EndElement && !xml.hasError()) {
        if (xml.isCharacters()) text += xml.text();
        if (xml.isStartElement()) forms << xml.readElementText();
    }
    if (forms.isEmpty()) forms << text;
    return unfinished || forms.contains(QString()) ? QStringList() : forms;
}

QHash<QByteArray, QStringList> read_texts(const QString& file) {
    QHash<QByteArray, QStringList> texts;
    QFile stored(file);
    if (!stored.open(QIODevice::ReadOnly))
        throw std::runtime_error("cannot read the translations " + file.toStdString());
    QXmlStreamReader xml(&stored);
    QByteArray context, source;
    while (!xml.atEnd()) {
        if (xml.readNext() != QXmlStreamReader::StartElement) continue;
        if (xml.name() == QLatin1String("name")) {
            context = xml.readElementText().toUtf8();
        } else if (xml.name() == QLatin1String("source")) {
            source = xml.readElementText().toUtf8();
        } else if (xml.name() == QLatin1String("translation")) {
            const QStringList forms = forms_of(xml);
            if (!forms.isEmpty()) texts.insert(key(context, source), forms);
        }
    }
    if (xml.hasError())
        throw std::runtime_error(file.toStdString() + ":" + std::to_string(xml.lineNumber()) + ": " +
                                 xml.errorString().toStdString());
    return texts;
}

/// Files of the program's resources do not change: each is read once, whoever switches the language back.
QHash<QByteArray, QStringList> texts_of(const QString& file) {
    if (!file.startsWith(QLatin1String(":/"))) return read_texts(file);
    static std::mutex mutex;
    static std::map<QString, QHash<QByteArray, QStringList>> known;
    const std::lock_guard lock(mutex);
    const auto found = known.find(file);
    return found != known.end() ? found->second : known.emplace(file, read_texts(file)).first->second;
}

}  // namespace

LinguistFile::LinguistFile(const QString& file) : texts_(texts_of(file)) {}

QString LinguistFile::translate(const char* context, const char* source, const char* /*disambiguation*/,
                                int n) const {
    const auto found = texts_.constFind(key(context, source));
    if (found == texts_.constEnd()) return {};
    return n >= 0 && n != 1 ? found->last() : found->first();
}

}  // namespace fulcrum::ui
