// What the scrubber shows: plot, colours of its bar, pictures of frames; and what that costs.
#include "app/docks/frame_preview.h"
#include "app/widgets/theme.h"
#include "tests/gui/timeline_window.h"

#include <QSet>

#include <chrono>

using namespace clothlab;

class TestScrubber : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TimelineWindow>(); }
    void cleanup() { m_window.reset(); }

    void thePlotKnowsEveryPackedFrame();
    void aPictureAppearsWhereTheMouseRests();
    void theBarSaysWhatIsKeptOfFrames();
    void whatIsOnDiskOnlyIsSaid();
    void paintingCostsTheSameForManyFrames();

private:
    Scrubber& scrubber() { return m_window->scrubber(); }
    Simulation& simulation() { return m_window->simulation(); }
    // Without a button, as a platform sends them.
    void moveMouse(QPoint at) {
        QTest::mouseEvent(QTest::MouseMove, scrubber().window()->windowHandle(), Qt::NoButton, {},
                          scrubber().mapTo(scrubber().window(), at));
    }

    // Of the bar, at that frame.
    static QColor colorAt(Scrubber& bar, double frame) {
        return bar.grab().toImage().pixelColor(qRound(bar.positionOf(frame)), bar.height() - 10);
    }

    std::unique_ptr<TimelineWindow> m_window;
};

void TestScrubber::thePlotKnowsEveryPackedFrame() {
    QVERIFY(m_window->simulateTo(40));
    TRY_COMPARE(scrubber().plot().frameCount(), 41);
    const auto check = [&](double FrameFacts::*what) {
        for (int frame = 0; frame < 41; ++frame) {
            const double value = factsOf(*simulation().recording().take(), frame)->*what;
            QCOMPARE(scrubber().plot().extent(frame, frame + 1).greatest, float(value));
        }
    };
    check(&FrameFacts::kineticEnergy);
    for (int begin = 0; begin < 41; ++begin)
        for (int end = begin + 1; end <= 41; ++end) {
            auto plain = scrubber().plot().extent(begin, begin + 1);
            for (int frame = begin; frame < end; ++frame) {
                const auto one = scrubber().plot().extent(frame, frame + 1);
                plain = {std::min(plain.least, one.least), std::max(plain.greatest, one.greatest)};
            }
            const auto extent = scrubber().plot().extent(begin, end);
            QVERIFY(extent.least == plain.least && extent.greatest == plain.greatest);
        }
    m_window->choose("plotQuantity", "Greatest strain");
    QCOMPARE(scrubber().plot().frameCount(), 41);
    check(&FrameFacts::greatestStrain);
    m_window->choose("plotQuantity", "No plot");
    QCOMPARE(scrubber().plot().frameCount(), 0);
    QVERIFY(!scrubber().grab().isNull());
}

void TestScrubber::aPictureAppearsWhereTheMouseRests() {
    QVERIFY(m_window->simulateTo(40));
    FramePreview& preview = scrubber().preview();
    QVERIFY(!preview.isVisible());
    moveMouse(m_window->onBar(10));
    moveMouse(m_window->onBar(20));
    TRY_COMPARE(preview.shownFrame(), 20);
    const QImage first = preview.picture();
    QSet<QRgb> colors;
    for (int y = 0; y < first.height(); ++y)
        for (int x = 0; x < first.width(); ++x)
            colors << first.pixel(x, y);
    QVERIFY2(colors.size() > 10, "a shaded sheet");
    moveMouse(m_window->onBar(40));
    TRY_COMPARE(preview.shownFrame(), 40);
    QVERIFY(preview.picture() != first); // it has moved
    moveMouse(m_window->onBar(20));
    TRY_COMPARE(preview.shownFrame(), 20);
    QCOMPARE(preview.picture(), first);
    QCOMPARE(m_window->frame(), 40); // hovering shows nothing in the view
    m_window->click(&scrubber(), m_window->onBar(30));
    QVERIFY(!preview.isVisible());
    moveMouse(QPoint(m_window->onBar(20).x(), 2)); // over the numbers
    QTest::qWait(200);
    QVERIFY(!preview.isVisible());
}

void TestScrubber::theBarSaysWhatIsKeptOfFrames() {
    const ThemeColors& colors = themeColors();
    QVERIFY(m_window->simulateTo(40));
    simulation().showFrame(20);
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    QCOMPARE(colorAt(scrubber(), 60), colors.field);
    m_window->typeInto(m_window->field("cloth.ks"), "900");
    m_window->key(Qt::Key_Return);
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    const QColor stale = colorAt(scrubber(), 30);
    QVERIFY(stale != colors.accent && stale != colors.field && stale.red() > stale.blue());

    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    m_window->key(Qt::Key_Space); // first what is recorded, which is not live
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    TRY_VERIFY(m_window->frameCount() > 50);
    QCOMPARE(colorAt(scrubber(), 43), colors.error);
    QCOMPARE(colorAt(scrubber(), 10), colors.accent);
    m_window->key(Qt::Key_Space);
    QCOMPARE(colorAt(scrubber(), 43), colors.accent);
}

void TestScrubber::whatIsOnDiskOnlyIsSaid() {
    QTemporaryDir folder;
    Document document;
    Simulation simulation(document, nullptr, 60'000); // bytes
    simulation.setJournals([&] { return folder.filePath("journal.clothtake"); });
    document.edit("sheet", smallScene());
    Scrubber bar(document, simulation);
    bar.resize(600, 100);
    const auto isOnDisk = [&](int frame) {
        const RecordedFrame& recorded = simulation.recording().frame(frame);
        return !recorded.exact && recorded.group && recorded.group->payload->bytesInMemory() == 0;
    };
    simulation.play();
    TRY_VERIFY(simulation.recording().frameCount() > 80 && isOnDisk(4));
    simulation.pause();
    const ThemeColors& colors = themeColors();
    TRY_VERIFY(colorAt(bar, 4) != colors.accent); // it is not asked with every frame
    QVERIFY(!isOnDisk(simulation.recording().lastFrame()));
    QVERIFY(colorAt(bar, 4) != colors.field);
    QCOMPARE(colorAt(bar, simulation.recording().lastFrame() - 1), colors.accent);
}

void TestScrubber::paintingCostsTheSameForManyFrames() {
    // A take of that many frames, all of which one packed group stands for.
    constexpr int many = 300'000;
    QVERIFY(m_window->simulateTo(16));
    TRY_COMPARE(scrubber().plot().frameCount(), 17);
    const auto group = simulation().recording().frame(3).group;
    const FramePointer start = simulation().look(0);
    auto take = std::make_shared<Take>(1, "long", start);
    take->frame(0).group = group;
    std::vector<std::shared_ptr<const FrameGroup>> groups;
    for (int first = 0; first < many; first += 16) {
        auto made = std::make_shared<FrameGroup>(*group);
        made->first = first;
        made->frames.assign(16, group->frames.front());
        for (int i = 0; i < 16; ++i)
            made->frames[std::size_t(i)].facts.kineticEnergy = 1 + std::sin((first + i) / 5000.0);
        groups.push_back(std::move(made));
    }
    for (int frame = 0; frame < many; ++frame) {
        if (frame > 0)
            take->append({start->scene, frame / 90.0, nullptr, nullptr, nullptr});
        take->frame(frame).group = groups[std::size_t(frame / 16)];
    }
    simulation().load({{take}, take, 0, start->scene}, {});
    TRY_COMPARE(scrubber().plot().frameCount(), many);

    using Clock = std::chrono::steady_clock;
    const auto milliseconds = [](Clock::duration time) {
        return std::chrono::duration<double, std::milli>(time).count();
    };
    QImage image(scrubber().size(), QImage::Format_ARGB32_Premultiplied);
    scrubber().render(&image); // makes what changes seldom
    constexpr int times = 200;
    const auto before = Clock::now();
    for (int i = 0; i < times; ++i)
        scrubber().render(&image);
    const double each = milliseconds(Clock::now() - before) / times;
    const auto beforeAll = Clock::now();
    for (int i = 0; i < 10; ++i) {
        scrubber().resize(scrubber().width() - 1, scrubber().height());
        scrubber().render(&image);
    }
    const double whole = milliseconds(Clock::now() - beforeAll) / 10;
    qInfo("%d frames: %.3f ms to paint, %.3f ms with plot and ticks", many, each, whole);
    QVERIFY2(each < 8, qPrintable(QString::number(each))); // O(frames) would be tens of ms
    QVERIFY2(whole < 40, qPrintable(QString::number(whole)));
}

CLOTHLAB_GUI_TEST_MAIN(TestScrubber)
#include "tst_scrubber.moc"
