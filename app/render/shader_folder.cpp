#include "app/render/shader_folder.h"

#include "app/render/shader_library.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>

namespace clothlab::render {
namespace {

constexpr int kSettleMilliseconds = 60;
const QStringList kPatterns{QStringLiteral("*.frag"), QStringLiteral("*.vert"), QStringLiteral("*.glsl")};

} // namespace

ShaderFolder::ShaderFolder(const QString& path, QObject* parent)
    : QObject(parent), m_path(path), m_names(listShaders(path)) {
    m_settled.setSingleShot(true);
    m_settled.setInterval(kSettleMilliseconds);
    connect(&m_settled, &QTimer::timeout, this, &ShaderFolder::look);
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, &m_settled, qOverload<>(&QTimer::start));
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, &m_settled, qOverload<>(&QTimer::start));
    if (path.isEmpty())
        return;
    m_watcher.addPath(path);
    m_contents = readFiles();
    if (!m_contents.isEmpty())
        m_watcher.addPaths(m_contents.keys());
}

QString ShaderFolder::fileOf(const QString& shader) const {
    return QDir(m_path).filePath(shader + QStringLiteral(".frag"));
}

QHash<QString, QByteArray> ShaderFolder::readFiles() const {
    QHash<QString, QByteArray> contents;
    const QDir directory(m_path);
    for (const QString& name : directory.entryList(kPatterns, QDir::Files)) {
        QFile file(directory.filePath(name));
        QCryptographicHash hash(QCryptographicHash::Md5);
        if (file.open(QIODevice::ReadOnly))
            hash.addData(&file);
        contents.insert(file.fileName(), hash.result());
    }
    return contents;
}

void ShaderFolder::look() {
    const QHash<QString, QByteArray> contents = readFiles();
    // A file that was replaced is another one, which is not watched yet.
    QStringList unwatched = contents.keys();
    for (const QString& watched : m_watcher.files())
        unwatched.removeAll(watched);
    if (!unwatched.isEmpty())
        m_watcher.addPaths(unwatched);
    if (contents == m_contents)
        return;
    m_contents = contents;
    const QStringList names = listShaders(m_path);
    if (names != m_names) {
        m_names = names;
        emit namesChanged();
    }
    emit filesChanged();
}

} // namespace clothlab::render
