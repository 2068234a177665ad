#include "app/cli/run_report.h"

#include "simcore/inspect/inspect.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace clothlab::cli {

std::string reportText(const RunSummary& summary, const Sheet& sheet, const Frame& last) {
    const Scene& scene = *last.scene;
    const auto steps = std::int64_t(summary.frames) * scene.simulation.stepsPerFrame;
    const double pointSteps = double(steps) * sheet.grid.pointCount();
    std::array<char, 20> hash{};
    std::snprintf(hash.data(), hash.size(), "%016llx",
                  static_cast<unsigned long long>(stateHash(last.state)));
    const auto strain = maxStrain(sheet, last.state.position);

    nlohmann::ordered_json report;
    report["points"] = sheet.grid.pointCount();
    report["springs"] = sheet.grid.springCount();
    report["frames"] = summary.frames;
    report["steps"] = steps;
    report["threads"] = summary.threads;
    report["seconds"] = summary.seconds;
    report["point_steps_per_second"] = summary.seconds > 0 ? pointSteps / summary.seconds : 0;
    report["milliseconds_per_frame"] = summary.frames > 0 ? 1000 * summary.seconds / summary.frames : 0;
    report["strain_limit_corrections"] = summary.strainLimitCorrections;
    for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending})
        report["max_strain"][std::string(name(type))] = strain[std::size_t(type)];
    report["kinetic_energy"] = kineticEnergy(scene, last.state);
    report["potential_energy"] = potentialEnergy(scene, sheet, last.state.position);
    report["state_hash"] = hash.data();
    report["finite"] = !summary.blowUp.has_value() && allFinite(last.state);
    if (summary.interrupted)
        report["interrupted"] = true;
    if (summary.blowUp) {
        const GridPoint place = sheet.grid.place(summary.blowUp->blowUp.point);
        report["blow_up"] = {{"frame", summary.blowUp->frame},
                             {"step", summary.blowUp->step},
                             {"phase", name(summary.blowUp->blowUp.phase)},
                             {"point", summary.blowUp->blowUp.point},
                             {"x", place.x},
                             {"y", place.y}};
    }
    return report.dump(2) + '\n';
}

} // namespace clothlab::cli
