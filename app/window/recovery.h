// Journals of recordings that are being made, and those that a crash has left.
#pragma once

#include <QLockFile>
#include <QString>
#include <QStringList>

#include <memory>

namespace clothlab {

// In a folder that programs share: each locks its journal as long as it runs. A journal is removed when
// another takes its place or the program ends; so one that nobody has locked is what is left of a crash.
class Recovery {
public:
    explicit Recovery(QString folder) : m_folder(std::move(folder)) {}
    ~Recovery() { remove(); }
    Recovery(const Recovery&) = delete;
    Recovery& operator=(const Recovery&) = delete;

    // The path of a new journal; empty, with the reason in words, if the folder cannot be used.
    QString begin(QString& problem);

    QStringList left() const; // paths, the latest first
    // Locks one for good; false if another program has taken it meanwhile.
    bool claim(const QString& journal);
    void discard(const QString& journal); // one that is claimed

private:
    void remove(); // the journal at hand

    QString m_folder;
    QString m_journal;
    std::unique_ptr<QLockFile> m_lock;
    QString m_claimed;
    std::unique_ptr<QLockFile> m_claimedLock;
};

} // namespace clothlab
