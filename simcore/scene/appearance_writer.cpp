#include "simcore/scene/appearance_writer.h"

#include "simcore/scene/json_text.h"
#include "simcore/scene/known_keys.h"

namespace clothlab {
namespace {

std::string valueText(bool value) {
    return flagText(value);
}

std::string valueText(int value) {
    return std::to_string(value);
}

std::string valueText(double value) {
    return json::numberText(value);
}

std::string valueText(const std::string& value) {
    return json::quoted(value);
}

std::string valueText(const std::array<double, 3>& value) {
    return tripleText(value);
}

std::string valueText(const std::optional<Rgb>& value) {
    return tripleText(value.value());
}

std::string valueText(SpringColoring value) {
    return json::quoted(value == SpringColoring::ByStrain ? "strain" : "type");
}

std::string valueText(const std::vector<double>& numbers) {
    std::string text;
    for (const double number : numbers)
        text += (text.empty() ? "[" : ", ") + json::numberText(number);
    return text + "]";
}

std::string valueText(const UniformValue& value) {
    return std::visit([](const auto& each) { return valueText(each); }, value);
}

Entries springEntries(const Appearance& appearance) {
    Entries entries;
    if (appearance.springsDrawn != Appearance{}.springsDrawn) {
        for (std::size_t type = 0; type < kSpringsDrawnKeys.size(); ++type)
            add(entries, kSpringsDrawnKeys[type], flagText(appearance.springsDrawn[type]));
    }
    addUnknown(entries, appearance.unknownSpringKeys);
    return entries;
}

Entries textureEntries(const Appearance& appearance) {
    Entries entries;
    for (std::size_t i = 0; i < kTextureKeys.size(); ++i) {
        if (!appearance.textures[i].empty())
            add(entries, kTextureKeys[i], json::quoted(appearance.textures[i]));
    }
    addUnknown(entries, appearance.unknownTextureKeys);
    return entries;
}

// A shader without values is written, too: a scene is read back as it was.
Entries uniformEntries(const Appearance& appearance) {
    Entries shaders;
    for (const auto& [shader, values] : appearance.uniforms) {
        Entries entries;
        for (const auto& [name, value] : values)
            add(entries, name, valueText(value));
        add(shaders, shader, objectText(entries, 3));
    }
    return shaders;
}

class AppearanceWriter {
public:
    explicit AppearanceWriter(const Appearance& appearance) : m_appearance(appearance) {}

    template <typename Value>
    void value(std::string_view key, Value Appearance::*member) {
        if (m_appearance.*member != m_default.*member)
            add(m_entries, key, valueText(m_appearance.*member));
    }

    void object(std::string_view key, const Entries& members) {
        if (!members.empty())
            add(m_entries, key, objectText(members, 2));
    }

    Entries finish() && {
        addUnknown(m_entries, m_appearance.unknownKeys);
        return std::move(m_entries);
    }

private:
    const Appearance& m_appearance;
    const Appearance m_default;
    Entries m_entries;
};

} // namespace

Entries appearanceEntries(const Appearance& appearance) {
    AppearanceWriter writer(appearance);
    writer.value("shader", &Appearance::shader);
    writer.value("color", &Appearance::color);
    writer.value("back_color", &Appearance::backColor);
    writer.value("two_sided", &Appearance::twoSided);
    writer.object("springs_drawn", springEntries(appearance));
    writer.value("springs_over_surface", &Appearance::springsOverSurface);
    writer.value("springs_colored_by", &Appearance::springColoring);
    writer.value("strain_range", &Appearance::strainRange);
    writer.value("light_position", &Appearance::lightPosition);
    writer.value("light_intensity", &Appearance::lightIntensity);
    writer.value("shadows", &Appearance::shadows);
    writer.value("background", &Appearance::background);
    writer.value("ground_grid", &Appearance::groundGrid);
    writer.value("axes", &Appearance::axes);
    writer.value("samples", &Appearance::samples);
    writer.value("mesh_resolution", &Appearance::meshResolution);
    writer.value("normal_scaling", &Appearance::normalScaling);
    writer.value("height_scaling", &Appearance::heightScaling);
    writer.object("textures", textureEntries(appearance));
    writer.value("cubemap", &Appearance::cubemap);
    writer.object("uniforms", uniformEntries(appearance));
    return std::move(writer).finish();
}

} // namespace clothlab
