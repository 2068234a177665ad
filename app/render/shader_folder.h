// The folder of shaders as it is on disk, and what happens to it.
#pragma once

#include <QFileSystemWatcher>
#include <QHash>
#include <QObject>
#include <QStringList>
#include <QTimer>

namespace clothlab::render {

// Watches the files of one folder, also those that editors replace instead of writing to.
class ShaderFolder : public QObject {
    Q_OBJECT

public:
    explicit ShaderFolder(const QString& path, QObject* parent = nullptr);

    const QString& path() const { return m_path; } // empty: there is none
    const QStringList& names() const { return m_names; }

    // NAME.frag; of Wireframe, too.
    QString fileOf(const QString& shader) const;

signals:
    void namesChanged();
    void filesChanged(); // of any file there, soon after it was written

private:
    void look();
    QHash<QString, QByteArray> readFiles() const;

    QString m_path;
    QStringList m_names;
    QHash<QString, QByteArray> m_contents; // of each file, as a hash
    QFileSystemWatcher m_watcher;
    QTimer m_settled; // files are written in several goes
};

} // namespace clothlab::render
