#include "app/window/recovery.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>

#include <utility>

namespace clothlab {
namespace {

const QString kEnding = QStringLiteral(".clothtake");

std::unique_ptr<QLockFile> lockOf(const QString& journal) {
    auto lock = std::make_unique<QLockFile>(journal + ".lock");
    lock->setStaleLockTime(0); // however long it has been locked: that a program runs is what counts
    return lock;
}

} // namespace

QString Recovery::begin(QString& problem) {
    remove();
    if (m_folder.isEmpty())
        return {};
    const QString name = QStringLiteral("%1/%2-%3")
                             .arg(m_folder, QDateTime::currentDateTime().toString("yyyy-MM-dd-HHmmss-zzz"),
                                  QString::number(QCoreApplication::applicationPid()));
    auto lock = lockOf(name + kEnding);
    if (!QDir().mkpath(m_folder) || !lock->tryLock()) {
        problem =
            QCoreApplication::translate(
                "Recovery", "A crash would lose what is recorded, and the recording has to fit in memory: %1 "
                            "cannot be written. Check its permissions and the room on its disk.")
                .arg(QDir::toNativeSeparators(m_folder));
        return {};
    }
    m_lock = std::move(lock);
    m_journal = name + kEnding;
    return m_journal;
}

void Recovery::remove() {
    if (!m_lock)
        return;
    QFile::remove(m_journal);
    m_lock.reset(); // removes the lock, too
    m_journal.clear();
}

QStringList Recovery::left() const {
    QStringList found;
    if (m_folder.isEmpty())
        return found;
    const QDir folder(m_folder);
    for (const QString& name : folder.entryList({"*" + kEnding}, QDir::Files, QDir::Name | QDir::Reversed)) {
        const QString path = folder.filePath(name);
        if (path == m_journal || path == m_claimed)
            continue;
        if (lockOf(path)->tryLock()) // and let go of it at once
            found << path;
    }
    return found;
}

bool Recovery::claim(const QString& journal) {
    auto lock = lockOf(journal);
    if (!lock->tryLock())
        return false;
    m_claimedLock = std::move(lock);
    m_claimed = journal;
    return true;
}

void Recovery::discard(const QString& journal) {
    QFile::remove(journal);
    if (journal == m_claimed) {
        m_claimedLock.reset();
        m_claimed.clear();
    }
}

} // namespace clothlab
