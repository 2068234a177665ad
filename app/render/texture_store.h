// Textures and cube maps made of files, kept as long as they are used.
#pragma once

#include "app/render/gl_functions.h"
#include "app/render/irradiance.h"
#include "app/render/problem.h"

#include <QSize>
#include <QString>

#include <map>
#include <optional>

namespace clothlab::render {

struct Texture {
    GLuint id = 0;
    QSize size; // texels
};

struct Cubemap {
    GLuint id = 0;
    int levels = 1; // of its mipmap
    Irradiance irradiance{};
};

// What can't be read is replaced by a checker and said in problems(). Holds GL objects of one context;
// nothing is freed by the destructor, which may run without a context.
class TextureStore {
public:
    // Where files with relative names are. No context needed.
    void setDirectory(const QString& directory);

    // Reads the files again when they are next asked for. No context needed.
    void reload() { m_stale = true; }

    // A new picture begins: what was not asked for in the last one may go.
    void beginFrame(Gl& gl);

    // Repeats, with mipmaps; the upper row of the file is at v = 0. srgb: texels are decoded to linear light.
    const Texture& texture(Gl& gl, const QString& file, bool srgb);

    // posx, negx, posy, negy, posz, negz of the folder, .png or .jpg, each square and of one size; texels as
    // they are.
    const Cubemap& cubemap(Gl& gl, const QString& folder);

    void destroy(Gl& gl);

    // Of an earlier context that was lost nothing is left to free.
    void forget() {
        m_textures.clear();
        m_cubemaps.clear();
    }

    // What is wrong with files of the last picture.
    Problems problems() const;

private:
    template <typename T>
    struct Entry {
        T value;
        std::optional<Problem> problem;
        int lastUsed = 0;
    };

    QString pathOf(const QString& name) const;
    void loadTexture(Gl& gl, const QString& path, bool srgb, Entry<Texture>& entry);
    void loadCubemap(Gl& gl, const QString& folder, Entry<Cubemap>& entry);
    template <typename Map>
    void dropUnused(Gl& gl, Map& map);

    QString m_directory;
    std::map<std::pair<QString, bool>, Entry<Texture>> m_textures;
    std::map<QString, Entry<Cubemap>> m_cubemaps;
    int m_frame = 0;
    bool m_stale = false;
};

} // namespace clothlab::render
