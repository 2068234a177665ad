#include "app/widgets/icons.h"

#include "app/widgets/theme.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmapCache>
#include <QSvgRenderer>
#include <QtDebug>

namespace clothlab {

namespace {

QString pathOf(const QString& name) {
    return QStringLiteral(":/icons/%1.svg").arg(name);
}

void replaceColor(QByteArray& svg, const char* drawn, const QColor& wanted) {
    svg.replace(drawn, wanted.name().toLatin1());
}

// Fills in what the drawing leaves to the theme. The files carry the light theme's colours of springs, so
// that any viewer shows them as they are meant.
QByteArray colored(QByteArray svg, QIcon::Mode mode, QIcon::State state) {
    const ThemeColors& c = themeColors();
    const bool disabled = mode == QIcon::Disabled;
    const bool selected = mode == QIcon::Selected; // in a row that is
    const bool on = state == QIcon::On && !disabled && !selected;
    const QColor line = disabled   ? c.disabledText
                        : selected ? QGuiApplication::palette().color(QPalette::HighlightedText)
                                   : c.text;

    replaceColor(svg, "#0072B2", on ? c.structural : line);
    replaceColor(svg, "#E69F00", on ? c.shearing : line);
    replaceColor(svg, "#009E73", on ? c.bending : line);
    replaceColor(svg, "#E5484D", on ? c.error : line);
    replaceColor(svg, "#D7263D", disabled ? line : c.error);
    replaceColor(svg, "#C77700", disabled ? line : c.warning);
    replaceColor(svg, "currentColor", on ? c.accent : line);
    return svg;
}

class ThemedIconEngine : public QIconEngine {
public:
    explicit ThemedIconEngine(const QString& name) : m_name(name) {
        QFile file(pathOf(name));
        if (file.open(QIODevice::ReadOnly)) {
            m_svg = file.readAll();
        }
        // A picture of its own, like the application's, keeps its colours.
        m_themed = m_svg.contains("currentColor");
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        QSvgRenderer renderer(m_themed ? colored(m_svg, mode, state) : m_svg);
        renderer.setAspectRatioMode(Qt::KeepAspectRatio);
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        if (!m_themed && mode == QIcon::Disabled) {
            painter->setOpacity(painter->opacity() * 0.4);
        }
        renderer.render(painter, QRectF(rect));
        painter->restore();
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QStringLiteral("clothlab-icon/%1/%2x%3/%4/%5/%6")
                                .arg(m_name)
                                .arg(size.width())
                                .arg(size.height())
                                .arg(int(mode))
                                .arg(int(state))
                                .arg(int(currentTheme()));
        QPixmap pixmap;
        if (!QPixmapCache::find(key, &pixmap)) {
            pixmap = QPixmap(size);
            pixmap.fill(Qt::transparent);
            QPainter painter(&pixmap);
            paint(&painter, QRect(QPoint(), size), mode, state);
            painter.end();
            QPixmapCache::insert(key, pixmap);
        }
        return pixmap;
    }

    // `size` is in device pixels already.
    QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State state, qreal) override {
        return pixmap(size, mode, state);
    }

    QSize actualSize(const QSize& size, QIcon::Mode, QIcon::State) override { return size; }
    QString iconName() override { return m_name; }
    QString key() const override { return QStringLiteral("clothlab"); }
    bool isNull() override { return m_svg.isEmpty(); }
    QIconEngine* clone() const override { return new ThemedIconEngine(*this); }

private:
    QString m_name;
    QByteArray m_svg;
    bool m_themed = false;
};

} // namespace

QIcon themedIcon(const QString& name) {
    initResources();
    if (!QFile::exists(pathOf(name))) {
        qWarning("No icon is called \"%s\"", qPrintable(name));
        return {};
    }
    return QIcon(new ThemedIconEngine(name));
}

QStringList iconNames() {
    initResources();
    QStringList names;
    const QStringList files =
        QDir(QStringLiteral(":/icons")).entryList({QStringLiteral("*.svg")}, QDir::Files);
    for (const QString& file : files) {
        names.append(file.chopped(4));
    }
    names.sort();
    return names;
}

} // namespace clothlab
