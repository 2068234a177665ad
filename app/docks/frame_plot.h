// One quantity of every frame of a take, ready to be drawn however many frames there are.
#pragma once

#include "simcore/recording/take.h"

#include <QString>

#include <span>
#include <vector>

namespace clothlab {

enum class PlotQuantity { None, KineticEnergy, GreatestStrain, Contacts };

QString quantityName(PlotQuantity quantity);
QString quantityText(PlotQuantity quantity, double value); // three digits and the unit

class FramePlot {
public:
    struct Extent {
        float least = 0;
        float greatest = 0;
    };

    void setQuantity(PlotQuantity quantity);
    PlotQuantity quantity() const { return m_quantity; }

    // Takes in what is known by now of the take's frames, so many of them at most; of another take than
    // before, from the first on. Returns whether there may be more.
    bool extend(const TakePointer& take, int mostFrames);

    int frameCount() const { return m_levels.empty() ? 0 : int(m_levels[0].size()); } // that are known
    Extent whole() const;
    // Of the frames from begin to before end, of those that are known: one at least. Costs the logarithm of
    // their number.
    Extent extent(int begin, int end) const;

private:
    void add(float value);

    PlotQuantity m_quantity = PlotQuantity::KineticEnergy;
    std::weak_ptr<const Take> m_take;
    // The frames, then pairs of them, pairs of pairs …, as far as they are full.
    std::vector<std::vector<Extent>> m_levels;
};

} // namespace clothlab
