// SPDX-License-Identifier: GPL-3.0-or-later
// A paint device that records the positions of words and filled shapes instead of painting them.
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>
#include <QRectF>
#include <QString>
#include <vector>

namespace fulcrum::ui::window_test {

struct PaintedWords {
    QString words;
    QRectF place;
    bool whole = true;  ///< not cut off by its box
};

class WordsEngine : public QPaintEngine {
  public:
    WordsEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState& now) override {
        if (now.state() & DirtyTransform) transform_ = now.transform();
        if (now.state() & (DirtyClipRegion | DirtyClipPath | DirtyClipEnabled)) {
            clip_ = QRectF();
            if (now.isClipEnabled())
                clip_ = now.state() & DirtyClipPath ? now.clipPath().boundingRect()
                                                    : QRectF(now.clipRegion().boundingRect());
        }
    }
    void drawPixmap(const QRectF&, const QPixmap&, const QRectF&) override {}
    void drawPath(const QPainterPath& path) override { keep_shape(path.boundingRect()); }
    void drawPolygon(const QPointF* points, int count, PolygonDrawMode) override {
        QPolygonF polygon;
        for (int i = 0; i < count; ++i) polygon << points[i];
        keep_shape(polygon.boundingRect());
    }
    void drawRects(const QRectF* rects, int count) override {
        for (int i = 0; i < count; ++i) keep_shape(rects[i]);
    }
    void drawLines(const QLineF*, int) override {}
    void drawTextItem(const QPointF& point, const QTextItem& item) override {
        const QRectF place(point.x(), point.y() - item.ascent(), item.width(),
                           item.ascent() + item.descent());
        if (item.text().trimmed().isEmpty()) return;
        // px: regions have whole pixels, and a letter may exceed its advance by one.
        const bool whole = clip_.isNull() || clip_.adjusted(-1, -1, 1, 1).contains(place);
        words.push_back({item.text(), transform_.mapRect(place), whole});
    }
    Type type() const override { return User; }

    std::vector<PaintedWords> words;
    std::vector<QRectF> shapes;

  private:
    void keep_shape(const QRectF& shape) { shapes.push_back(transform_.mapRect(shape)); }
    QTransform transform_;
    QRectF clip_;
};

class WordsDevice : public QPaintDevice {
  public:
    /// dots_per_inch: from the desktop's text scale, 96 at 100 %.
    explicit WordsDevice(QSize size, int dots_per_inch = 96) : size_(size), dots_per_inch_(dots_per_inch) {}
    QPaintEngine* paintEngine() const override { return &engine_; }
    const std::vector<PaintedWords>& words() const { return engine_.words; }
    const std::vector<QRectF>& shapes() const { return engine_.shapes; }

  protected:
    int metric(PaintDeviceMetric which) const override {
        switch (which) {
            case PdmWidth:
                return size_.width();
            case PdmHeight:
                return size_.height();
            case PdmDpiX:
            case PdmDpiY:
            case PdmPhysicalDpiX:
            case PdmPhysicalDpiY:
                return dots_per_inch_;
            case PdmDepth:
                return 32;
            case PdmDevicePixelRatio:
                return 1;
            default:
                return QPaintDevice::metric(which);
        }
    }

  private:
    QSize size_;
    int dots_per_inch_;
    mutable WordsEngine engine_;
};

}  // namespace fulcrum::ui::window_test
