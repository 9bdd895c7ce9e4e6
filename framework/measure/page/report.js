// What report.html does beyond showing itself: plots that answer the pointer, and two pictures
// under one slider. Without it the page shows static plots and the pictures side by side.
"use strict";
(() => {
  const data = JSON.parse(document.getElementById("lab-data").textContent);
  const dark = matchMedia("(prefers-color-scheme: dark)");
  const ink = (index) => data.inks[index % data.inks.length][dark.matches ? 1 : 0];
  const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim();

  function element(parent, tag, kind, text) {
    const made = document.createElement(tag);
    if (kind) made.className = kind;
    if (text !== undefined) made.textContent = text;
    parent.append(made);
    return made;
  }

  function choice(parent, name, options, onChange) {
    const label = element(parent, "label", "", name + " ");
    const select = element(label, "select");
    options.forEach((option, i) => {
      element(select, "option", "", option).value = i;
    });
    select.addEventListener("change", onChange);
    return select;
  }

  // "0.02", "500", "1e-5": as short as it can be.
  const short = (value) => String(Number(value.toPrecision(3)));

  // A label at powers of ten; on a short axis at 2 and 5, too.
  function labelled(value, decades) {
    const mantissa = value / 10 ** Math.floor(Math.log10(value) + 1e-9);
    const is = (wanted) => Math.abs(mantissa - wanted) < 1e-6;
    return is(1) || (decades < 2.5 && (is(2) || is(5)));
  }

  // 1…9 times every power of ten within the axis.
  function splits(u, index, least, most) {
    const all = [];
    for (let power = Math.floor(Math.log10(least)); 10 ** power <= most; ++power) {
      for (let m = 1; m <= 9; ++m) {
        const value = m * 10 ** power;
        if (value >= least && value <= most) all.push(value);
      }
    }
    return all;
  }

  // The points that no other beats in both time and error.
  function pareto(points) {
    const order = [...points].sort((a, b) => a.t - b.t || a.e - b.e);
    let best = Infinity;
    return order.filter((point) => {
      const better = point.e < best;
      best = Math.min(best, point.e);
      return better;
    });
  }

  // The points of a plane by one metric; error 0 is put on a row of its own, a decade below all.
  function pointsOf(plane, metric) {
    const all = [];
    plane.series.forEach((series, index) => {
      for (const point of series.points) {
        const error = point.errors[metric];
        if (error === null || !(error >= 0) || !(point.ms > 0)) continue;
        all.push({ index, series, point, t: point.ms, e: error });
      }
    });
    const positive = all.map((p) => p.e).filter((e) => e > 0);
    const least = positive.length ? Math.min(...positive) : 1;
    const floor = 10 ** (Math.floor(Math.log10(least)) - 1);
    for (const p of all) p.y = p.e > 0 ? p.e : floor;
    return { all, floor, exact: all.some((p) => p.e === 0) };
  }

  function tableOf(plane, points) {
    const times = [...new Set(points.map((p) => p.t))].sort((a, b) => a - b);
    const at = new Map(times.map((t, i) => [t, i]));
    const rows = plane.series.map(() => new Array(times.length).fill(null));
    for (const p of points) rows[p.index][at.get(p.t)] = p.y;
    return [times, ...rows];
  }

  const limits = (values, air) => [Math.min(...values) / air, Math.max(...values) * air];

  function axis(label, size, text) {
    return {
      label, size, labelSize: 28, stroke: colour("--soft"), font: "14px system-ui, sans-serif",
      labelFont: "15px system-ui, sans-serif", grid: { stroke: colour("--line"), width: 1 },
      ticks: { stroke: colour("--line") }, splits,
      filter: (u, values) => values, values: (u, values) => values.map(text),
    };
  }

  // Rings around the Pareto points, and a line at the baseline's time.
  function drawMarks(u, best, baselineMs) {
    const ratio = devicePixelRatio;
    u.ctx.save();
    u.ctx.strokeStyle = colour("--ink");
    u.ctx.lineWidth = 1.5 * ratio;
    for (const p of best) {
      if (!u.series[p.index + 1].show) continue;
      u.ctx.beginPath();
      u.ctx.arc(u.valToPos(p.t, "x", true), u.valToPos(p.y, "y", true), 9 * ratio, 0, 7);
      u.ctx.stroke();
    }
    u.ctx.setLineDash([2 * ratio, 5 * ratio]);
    u.ctx.strokeStyle = colour("--soft");
    const x = u.valToPos(baselineMs, "x", true);
    u.ctx.beginPath();
    u.ctx.moveTo(x, u.bbox.top);
    u.ctx.lineTo(x, u.bbox.top + u.bbox.height);
    u.ctx.stroke();
    u.ctx.restore();
  }

  // Says what the point nearest to the pointer is.
  function tell(u, tip, points, metric) {
    const { left, top } = u.cursor;
    let nearest = null, distance = 30;
    for (const p of points) {
      if (!u.series[p.index + 1].show || left < 0) continue;
      const d = Math.hypot(u.valToPos(p.t, "x") - left, u.valToPos(p.y, "y") - top);
      if (d < distance) [nearest, distance] = [p, d];
    }
    tip.hidden = nearest === null;
    if (nearest === null) return;
    const { series, point, t, e } = nearest;
    tip.textContent = `${series.name} ${point.setting}: ${metric} ${e === 0 ? "0 (exact)" : short(e)}, ` +
      `${short(t)} ms, ${short(point.speedup)} × the baseline's pace`;
    const x = u.valToPos(t, "x"), width = u.over.clientWidth;
    tip.style.left = Math.min(x + 14, Math.max(0, width - tip.offsetWidth)) + "px";
    tip.style.top = Math.max(0, u.valToPos(nearest.y, "y") - tip.offsetHeight - 14) + "px";
  }

  function seriesStyles(plane) {
    return plane.series.map((series, i) => ({
      label: series.name, stroke: ink(series.ink), width: 2.5, spanGaps: true,
      dash: series.by_samples ? [8, 6] : undefined,
      points: { show: true, size: 10, fill: series.by_samples ? colour("--card") : ink(series.ink),
        stroke: ink(series.ink), width: 2.5 },
    }));
  }

  function plot(holder, scene, plane, metric) {
    holder.textContent = "";
    const { all, floor, exact } = pointsOf(plane, metric.name);
    if (all.length === 0) return void element(holder, "p", "soft", "Nothing was measured here.");
    const x = limits([...all.map((p) => p.t), scene.baseline_ms], 1.4);
    const y = limits(all.map((p) => p.y), 1.6);
    const decades = (range) => Math.log10(range[1] / range[0]);
    const text = (range) => (v) => (labelled(v, decades(range)) ? short(v) : "");
    const yText = (v) => (exact && Math.abs(v / floor - 1) < 1e-6 ? "0: exact" :
      exact && v < floor * 9.99 ? "" : text(y)(v));
    const best = pareto(all);
    const tip = document.createElement("div");
    const u = new uPlot({
      width: holder.clientWidth, height: 460, legend: { live: false },
      cursor: { points: { show: false }, drag: { x: false, y: false } },
      scales: { x: { distr: 3, time: false, range: () => x }, y: { distr: 3, range: () => y } },
      axes: [axis(scene.time_label, 44, text(x)),
        axis(`${metric.label}, as displayed`, 76, yText)],
      series: [{}, ...seriesStyles(plane)],
      hooks: {
        draw: [(self) => drawMarks(self, best, scene.baseline_ms)],
        setCursor: [(self) => tell(self, tip, all, metric.label)],
      },
    }, tableOf(plane, all), holder);
    tip.className = "tip";
    tip.hidden = true;
    u.over.append(tip);
  }

  function livePlot(figure, scene) {
    const box = document.createElement("div");
    box.className = "live";
    const bar = element(box, "div", "bar");
    const truth = choice(bar, "against", scene.planes.map((plane) => plane.truth), () => draw());
    const metric = choice(bar, "by", data.metrics.map((m) => m.label), () => draw());
    element(bar, "span", "soft", "ringed: no other point is both faster and better");
    const holder = element(box, "div", "holder");
    truth.value = scene.first;
    metric.value = data.metrics.findIndex((m) => m.name === data.yardstick);
    const draw = () => plot(holder, scene, scene.planes[truth.value], data.metrics[metric.value]);
    figure.after(box);
    figure.hidden = true;
    draw();
    dark.addEventListener("change", draw);
    addEventListener("resize", draw);
    // Printed is the static plot: it fits any paper.
    addEventListener("beforeprint", () => { figure.hidden = false; box.hidden = true; });
    addEventListener("afterprint", () => { figure.hidden = true; box.hidden = false; draw(); });
  }

  function slider(box) {
    const figures = [...document.querySelectorAll(`#${box.dataset.section} .pictures figure`)];
    if (figures.length < 2) return;
    const names = figures.map((f) => f.querySelector("figcaption").textContent.trim());
    const bar = element(box, "div", "bar");
    const left = choice(bar, "left", names, () => show());
    const right = choice(bar, "right", names, () => show());
    const stack = element(box, "div", "stack");
    const under = element(stack, "img"), over = element(stack, "img", "over");
    const range = element(box, "input");
    range.type = "range";
    range.min = 0, range.max = 100, range.step = 0.1, range.value = 50;
    range.setAttribute("aria-label", "where the left picture ends");
    const move = () => stack.style.setProperty("--at", range.value + "%");
    const show = () => {
      [[under, left], [over, right]].forEach(([image, select]) => {
        image.src = figures[select.value].querySelector("img").src;
        image.alt = names[select.value];
      });
    };
    const drag = (event) => {
      if (event.type === "pointermove" && event.buttons === 0) return;
      const edge = stack.getBoundingClientRect();
      range.value = 100 * (event.clientX - edge.left) / edge.width;
      move();
    };
    right.value = Math.min(Number(box.dataset.right), figures.length - 1);
    range.addEventListener("input", move);
    stack.addEventListener("pointerdown", drag);
    stack.addEventListener("pointermove", drag);
    stack.addEventListener("dragstart", (event) => event.preventDefault());
    box.hidden = false;
    show();
    move();
  }

  document.querySelectorAll("figure.plot").forEach((figure, i) => {
    if (data.scenes[i].planes.length > 0) livePlot(figure, data.scenes[i]);
  });
  document.querySelectorAll(".compare").forEach(slider);
})();
