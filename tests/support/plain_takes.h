// What Simulation and the undo stack make of takes, once more, plainly: each take holds all of its frames,
// each frame is the stiffness it was computed with, and a sheet is its number of rows.
#pragma once

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace clothlab::test {

class PlainTakes {
public:
    struct User {
        double ks;
        int rows;
        friend bool operator==(const User&, const User&) = default;
    };
    struct Take {
        std::string name;
        int parent = 0; // 0: none
        int branchFrame = -1;
        int rows = 0;
        std::vector<double> frames;
    };

    explicit PlainTakes(User user) : m_user(user) { begin(); }

    // --- what the user does
    void record() {
        if (stale() < count()) {
            const Take& from = take();
            int parent = m_open;
            while (m_takes[parent].branchFrame >= stale() - 1)
                parent = m_takes[parent].parent;
            const int shown = std::min(m_shown, stale() - 1);
            add({freeName(),
                 parent,
                 stale() - 1,
                 from.rows,
                 {from.frames.begin(), from.frames.begin() + stale()}});
            m_shown = shown;
        }
        m_takes[m_open].frames.push_back(m_user.ks);
        m_stale = kNone;
        m_marks.clear();
        m_shown = count() - 1;
    }
    void show(int frame) { m_shown = std::clamp(frame, 0, count() - 1); }
    void restart() { begin(); }
    void edit(User user) {
        if (!(user == m_user))
            push(Step{Step::Edit, {}, user, 0, {}});
    }
    void open(int id) {
        if (id != m_open && m_listed.contains(id))
            push(openStep(id));
    }
    void rename(int id, const std::string& name) {
        if (m_listed.contains(id) && m_takes[id].name != name)
            push(Step{Step::Rename, {}, m_user, id, name});
    }
    void remove(int id) {
        if (!m_listed.contains(id) || m_listed.size() < 2)
            return;
        std::vector<Step> steps;
        if (id == m_open) {
            int next = listedParent(id);
            if (next == 0) {
                const auto place = m_listed.find(id);
                next = place == m_listed.begin() ? *std::next(place) : *std::prev(place);
            }
            steps.push_back(openStep(next));
        }
        steps.push_back(Step{Step::Delete, {}, m_user, id, {}});
        m_done.resize(std::size_t(m_index));
        for (Step& step : steps)
            redo(step);
        m_done.push_back(std::move(steps));
        ++m_index;
    }
    void undo() {
        if (m_index == 0)
            return;
        std::vector<Step>& steps = m_done[std::size_t(--m_index)];
        for (auto step = steps.rbegin(); step != steps.rend(); ++step)
            undo(*step);
    }
    void redo() {
        if (m_index == int(m_done.size()))
            return;
        for (Step& step : m_done[std::size_t(m_index++)])
            redo(step);
    }

    // --- what there is then
    User user() const { return m_user; }
    const std::set<int>& listed() const { return m_listed; }
    const Take& take(int id) const { return m_takes.at(id); }
    const Take& take() const { return take(m_open); }
    int openTake() const { return m_open; }
    int count() const { return int(take().frames.size()); }
    int shown() const { return m_shown; }
    int stale() const { return std::min(m_stale, count()); }
    int listedParent(int id) const {
        int parent = take(id).parent;
        while (parent != 0 && !m_listed.contains(parent))
            parent = take(parent).parent;
        return parent;
    }

private:
    static constexpr int kNone = std::numeric_limits<int>::max();
    struct Mark { // an edit that made frames stale
        double before;
        int stale;
    };
    struct View {
        int take = 0;
        int shown = 0;
        int stale = kNone;
        std::vector<Mark> marks;
    };
    struct Step {
        enum Kind { Edit, Open, Rename, Delete } kind;
        View view;
        User user;
        int take;
        std::string name;
    };

    void add(Take take) {
        m_takes[++m_last] = std::move(take);
        m_listed.insert(m_last);
        m_open = m_last;
        m_shown = 0;
        m_stale = kNone;
        m_marks.clear();
    }
    void begin() {
        if (m_open != 0 && count() == 1)
            m_listed.erase(m_open);
        add({freeName(), 0, -1, m_user.rows, {m_user.ks}});
    }
    std::string freeName() const {
        for (int i = 1;; ++i) {
            const std::string name = "Take " + std::to_string(i);
            if (std::none_of(m_listed.begin(), m_listed.end(), [&](int id) { return take(id).name == name; }))
                return name;
        }
    }
    Step openStep(int id) const {
        const Take& t = take(id);
        return {Step::Open,
                {id, std::min(m_shown, int(t.frames.size()) - 1), kNone, {}},
                {t.frames.back(), t.rows},
                0,
                {}};
    }
    void push(Step step) {
        m_done.resize(std::size_t(m_index));
        redo(step);
        m_done.push_back({std::move(step)});
        ++m_index;
    }
    void exchange(Step& step) {
        if (step.kind == Step::Edit) {
            std::swap(m_user, step.user);
            changed(step.user);
        } else if (step.kind == Step::Open) {
            View now{m_open, m_shown, m_stale, m_marks};
            m_open = step.view.take;
            m_shown = step.view.shown;
            m_stale = step.view.stale;
            m_marks = step.view.marks;
            m_listed.insert(m_open);
            step.view = now;
            std::swap(m_user, step.user);
        } else {
            std::swap(m_takes[step.take].name, step.name);
        }
    }
    void redo(Step& step) {
        if (step.kind == Step::Delete) {
            step.name = step.take != m_open && m_listed.erase(step.take) > 0 ? "removed" : "";
        } else {
            exchange(step);
        }
    }
    void undo(Step& step) {
        if (step.kind != Step::Delete)
            exchange(step);
        else if (!step.name.empty())
            m_listed.insert(step.take);
    }

    void changed(User before) {
        if (before.rows != m_user.rows)
            otherSheet();
        else if (before.ks != m_user.ks)
            otherMotion(before.ks);
    }
    void otherSheet() {
        const bool empty = count() == 1;
        if (empty)
            m_listed.erase(m_open);
        else
            m_left.push_back({m_open, m_shown});
        for (auto left = m_left.end(); left != m_left.begin();) {
            --left;
            if (!m_listed.contains(left->first) || take(left->first).rows != m_user.rows)
                continue;
            const auto [id, shown] = *left;
            m_left.erase(left);
            m_open = id;
            m_shown = shown;
            m_stale = kNone;
            m_marks.clear();
            if (take().frames.back() != m_user.ks)
                otherMotion(take().frames.back());
            return;
        }
        add({freeName(), 0, -1, m_user.rows, {m_user.ks}});
    }
    void otherMotion(double before) {
        for (std::size_t i = 0; i < m_marks.size(); ++i)
            if (m_marks[i].before == m_user.ks) { // this and all edits since are undone
                m_stale = m_marks[i].stale;
                m_marks.resize(i);
                return;
            }
        const int first = std::min(stale(), m_shown + 1);
        const std::vector<double>& frames = take().frames;
        if (std::all_of(frames.begin() + first, frames.end(), [&](double ks) { return ks == m_user.ks; })) {
            m_stale = kNone;
            return;
        }
        if (first < stale())
            m_marks.push_back({before, m_stale});
        m_stale = first;
    }

    User m_user;
    std::map<int, Take> m_takes;
    std::set<int> m_listed;
    int m_last = 0;
    int m_open = 0;
    int m_shown = 0;
    int m_stale = kNone;
    std::vector<Mark> m_marks;
    std::vector<std::pair<int, int>> m_left;
    std::vector<std::vector<Step>> m_done;
    int m_index = 0;
};

} // namespace clothlab::test
