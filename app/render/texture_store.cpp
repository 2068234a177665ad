#include "app/render/texture_store.h"
#include "app/render/words.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QOpenGLContext>

#include <algorithm>
#include <bit>

namespace clothlab::render {
namespace {

// Of EXT_texture_filter_anisotropic, which is not in the headers of OpenGL 3.3.
constexpr GLenum kMaxAnisotropy = 0x84FE;
constexpr GLenum kGreatestMaxAnisotropy = 0x84FF;
constexpr float kAnisotropy = 8;

constexpr std::array<const char*, kCubeFaces> kFaceNames{"posx", "negx", "posy", "negy", "posz", "negz"};

void uploadImage(Gl& gl, GLenum target, const Image& image, bool srgb) {
    gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.glTexImage2D(target, 0, srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, image.width, image.height, 0, GL_RGBA,
                    GL_UNSIGNED_BYTE, image.rgba.data());
}

void setFilters(Gl& gl, GLenum target, GLint wrap) {
    gl.glGenerateMipmap(target);
    gl.glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    gl.glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    for (const GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        gl.glTexParameteri(target, axis, wrap);
}

// For planes seen at a low angle. Cube maps are looked at straight.
void setAnisotropy(Gl& gl) {
    const QOpenGLContext* context = QOpenGLContext::currentContext();
    // Mesa's software renderer pays dearly for it, and blurs what vertex shaders read.
    const QByteArray renderer(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER)));
    if (renderer.contains("llvmpipe") || renderer.contains("softpipe"))
        return;
    if (!context || !context->hasExtension("GL_EXT_texture_filter_anisotropic"))
        return;
    GLfloat greatest = 1;
    gl.glGetFloatv(kGreatestMaxAnisotropy, &greatest);
    gl.glTexParameterf(GL_TEXTURE_2D, kMaxAnisotropy, std::min(greatest, kAnisotropy));
}

QString faceFile(const QString& folder, const char* face) {
    for (const char* extension : {"png", "jpg", "jpeg"}) {
        QString path = QStringLiteral("%1/%2.%3").arg(folder, QLatin1String(face), QLatin1String(extension));
        if (QFile::exists(path))
            return path;
    }
    return QStringLiteral("%1/%2.png").arg(folder, QLatin1String(face));
}

std::optional<CubeImages> readFaces(const QString& folder, std::optional<Problem>& problem) {
    CubeImages faces;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const QString file = faceFile(folder, kFaceNames[i]);
        QString reason;
        std::optional<Image> image = readImage(file, reason);
        if (image &&
            (image->width != image->height || image->width != (i > 0 ? faces[0].width : image->width)))
            reason = tr("the six pictures of a cube map must be square and of one size");
        if (!reason.isEmpty()) {
            problem = Problem{file, 0, reason};
            return std::nullopt;
        }
        faces[i] = std::move(*image);
    }
    return faces;
}

} // namespace

void TextureStore::setDirectory(const QString& directory) {
    if (directory == m_directory)
        return;
    m_directory = directory;
    reload();
}

QString TextureStore::pathOf(const QString& name) const {
    return QDir::isAbsolutePath(name) ? name : QDir(m_directory).filePath(name);
}

template <typename Map>
void TextureStore::dropUnused(Gl& gl, Map& map) {
    for (auto it = map.begin(); it != map.end();) {
        if (it->second.lastUsed == m_frame && !m_stale) {
            ++it;
            continue;
        }
        gl.glDeleteTextures(1, &it->second.value.id);
        it = map.erase(it);
    }
}

void TextureStore::beginFrame(Gl& gl) {
    dropUnused(gl, m_textures);
    dropUnused(gl, m_cubemaps);
    m_stale = false;
    ++m_frame;
}

void TextureStore::destroy(Gl& gl) {
    m_stale = true;
    beginFrame(gl);
}

const Texture& TextureStore::texture(Gl& gl, const QString& file, bool srgb) {
    Entry<Texture>& entry = m_textures[{file, srgb}];
    entry.lastUsed = m_frame;
    if (entry.value.id == 0)
        loadTexture(gl, pathOf(file), srgb, entry);
    return entry.value;
}

void TextureStore::loadTexture(Gl& gl, const QString& path, bool srgb, Entry<Texture>& entry) {
    QString reason;
    std::optional<Image> image = readImage(path, reason);
    if (!image) {
        entry.problem = Problem{path, 0, reason};
        image = checker();
    }
    gl.glGenTextures(1, &entry.value.id);
    gl.glBindTexture(GL_TEXTURE_2D, entry.value.id);
    uploadImage(gl, GL_TEXTURE_2D, *image, srgb);
    setFilters(gl, GL_TEXTURE_2D, GL_REPEAT);
    setAnisotropy(gl);
    entry.value.size = QSize(image->width, image->height);
}

const Cubemap& TextureStore::cubemap(Gl& gl, const QString& folder) {
    Entry<Cubemap>& entry = m_cubemaps[folder];
    entry.lastUsed = m_frame;
    if (entry.value.id == 0)
        loadCubemap(gl, pathOf(folder), entry);
    return entry.value;
}

void TextureStore::loadCubemap(Gl& gl, const QString& folder, Entry<Cubemap>& entry) {
    std::optional<CubeImages> faces = readFaces(folder, entry.problem);
    if (!faces) {
        faces.emplace();
        faces->fill(checker());
    }
    gl.glGenTextures(1, &entry.value.id);
    gl.glBindTexture(GL_TEXTURE_CUBE_MAP, entry.value.id);
    for (std::size_t i = 0; i < faces->size(); ++i)
        uploadImage(gl, GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(i), (*faces)[i], false);
    setFilters(gl, GL_TEXTURE_CUBE_MAP, GL_CLAMP_TO_EDGE);
    entry.value.levels = std::bit_width(static_cast<unsigned>(faces->front().width));
    entry.value.irradiance = irradianceOf(*faces);
}

Problems TextureStore::problems() const {
    Problems problems;
    for (const auto& [name, entry] : m_textures)
        if (entry.lastUsed == m_frame && entry.problem)
            problems.append(*entry.problem);
    for (const auto& [name, entry] : m_cubemaps)
        if (entry.lastUsed == m_frame && entry.problem)
            problems.append(*entry.problem);
    return problems;
}

} // namespace clothlab::render
