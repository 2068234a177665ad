#include "app/docks/frame_plot.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <utility>

namespace clothlab {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("FramePlot", text);
}

double valueOf(PlotQuantity quantity, const FrameFacts& facts) {
    switch (quantity) {
    case PlotQuantity::KineticEnergy:
        return facts.kineticEnergy;
    case PlotQuantity::GreatestStrain:
        return facts.greatestStrain;
    case PlotQuantity::Contacts:
        return double(facts.contacts);
    case PlotQuantity::None:
        break;
    }
    return 0;
}

QString threeDigits(double value) {
    const double size = std::abs(value);
    const QString digits = QString::number(size, 'f', size < 9.995 ? 2 : size < 99.95 ? 1 : 0);
    return value < 0 ? QChar(0x2212) + digits : digits;
}

FramePlot::Extent both(const FramePlot::Extent& a, const FramePlot::Extent& b) {
    return {std::min(a.least, b.least), std::max(a.greatest, b.greatest)};
}

} // namespace

QString quantityName(PlotQuantity quantity) {
    switch (quantity) {
    case PlotQuantity::KineticEnergy:
        return translated("Kinetic energy");
    case PlotQuantity::GreatestStrain:
        return translated("Greatest strain");
    case PlotQuantity::Contacts:
        return translated("Contacts");
    case PlotQuantity::None:
        break;
    }
    return translated("No plot");
}

QString quantityText(PlotQuantity quantity, double value) {
    const double size = std::abs(value);
    switch (quantity) {
    case PlotQuantity::KineticEnergy:
        for (const auto& [least, unit] : {std::pair{1e3, "kJ"}, {1.0, "J"}, {1e-3, "mJ"}, {1e-6, "µJ"}})
            if (size >= least)
                return QStringLiteral("%1 %2").arg(threeDigits(value / least), QString::fromUtf8(unit));
        return QStringLiteral("0 J"); // nothing that could be seen
    case PlotQuantity::GreatestStrain:
        return size < 5e-5 ? QStringLiteral("0 %") : QStringLiteral("%1 %").arg(threeDigits(100 * value));
    case PlotQuantity::Contacts:
        return size < 9999.5 ? QString::number(value, 'f', 0)
                             : QStringLiteral("%1 k").arg(threeDigits(value / 1000));
    case PlotQuantity::None:
        break;
    }
    return {};
}

void FramePlot::setQuantity(PlotQuantity quantity) {
    if (std::exchange(m_quantity, quantity) != quantity)
        m_levels.clear();
}

bool FramePlot::extend(const TakePointer& take, int mostFrames) {
    if (m_take.lock() != take) {
        m_take = take;
        m_levels.clear();
    }
    if (m_quantity == PlotQuantity::None)
        return false;
    const Take& frames = *take;
    const int end = std::min<int>(frames.frameCount(), frameCount() + mostFrames);
    for (int frame = frameCount(); frame < end; ++frame) {
        const FrameFacts* facts = factsOf(frames, frame);
        if (!facts)
            return false; // not packed yet
        const double value = valueOf(m_quantity, *facts);
        add(std::isfinite(value) ? float(value) : 0.0F);
    }
    return end < frames.frameCount();
}

void FramePlot::add(float value) {
    if (m_levels.empty())
        m_levels.emplace_back();
    m_levels[0].push_back({value, value});
    for (std::size_t level = 0; m_levels[level].size() % 2 == 0; ++level) {
        if (level + 1 == m_levels.size())
            m_levels.emplace_back();
        const std::vector<Extent>& below = m_levels[level];
        m_levels[level + 1].push_back(both(below[below.size() - 2], below.back()));
    }
}

FramePlot::Extent FramePlot::whole() const {
    return frameCount() > 0 ? extent(0, frameCount()) : Extent{};
}

FramePlot::Extent FramePlot::extent(int begin, int end) const {
    Extent found = m_levels[0][std::size_t(begin)];
    auto first = std::size_t(begin);
    auto last = std::size_t(end); // both in units of the level
    for (std::size_t level = 0; first < last; ++level) {
        const std::vector<Extent>& here = m_levels[level];
        if (first % 2 == 1)
            found = both(found, here[first++]);
        if (last % 2 == 1 && first < last)
            found = both(found, here[--last]);
        first /= 2;
        last /= 2;
    }
    return found;
}

} // namespace clothlab
