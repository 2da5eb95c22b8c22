// SPDX-License-Identifier: GPL-3.0-or-later
// A paint device that keeps where words and filled shapes are painted instead of painting them.
#pragma once

#include <QPaintDevice>
#include <QPaintEngine>
#include <QPainterPath>
#include <QRectF>
#include <QString>
#include <vector>

namespace fulcrum::ui::test {

struct PaintedWords {
    QString words;
    QRectF place;
};

class WordsEngine : public QPaintEngine {
  public:
    WordsEngine() : QPaintEngine(AllFeatures) {}
    bool begin(QPaintDevice*) override { return true; }
    bool end() override { return true; }
    void updateState(const QPaintEngineState& now) override {
        if (now.state() & DirtyTransform) transform_ = now.transform();
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
        if (!item.text().trimmed().isEmpty()) words.push_back({item.text(), transform_.mapRect(place)});
    }
    Type type() const override { return User; }

    std::vector<PaintedWords> words;
    std::vector<QRectF> shapes;

  private:
    void keep_shape(const QRectF& shape) { shapes.push_back(transform_.mapRect(shape)); }
    QTransform transform_;
};

class WordsDevice : public QPaintDevice {
  public:
    explicit WordsDevice(QSize size) : size_(size) {}
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
                return 96;
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
    mutable WordsEngine engine_;
};

}  // namespace fulcrum::ui::test
