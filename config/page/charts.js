// Bar charts as SVG, and tables.
'use strict';
const SVG = 'http://www.w3.org/2000/svg';

function element(name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text !== undefined) made.textContent = text;
  return made;
}

function shortNumber(value) {
  if (value >= 1e4) return Math.round(value / 1e3) + 'k';
  return value >= 10 || Number.isInteger(value) ? String(Math.round(value)) : value.toFixed(2);
}

// labels: what stands below the first and the last bar.
function barChart(box, values, labels, unit) {
  const width = 320, height = 150, left = 34, bottom = 18, top = 6;
  const highest = Math.max(...values, 1e-9);
  const svg = element('svg', {viewBox: `0 0 ${width} ${height}`, role: 'img', 'aria-label': unit});
  const step = (width - left) / Math.max(values.length, 1);
  for (const share of [0, 0.5, 1]) {
    const y = height - bottom - share * (height - bottom - top);
    svg.append(element('line', {x1: left, x2: width, y1: y, y2: y}));
    svg.append(element('text', {x: left - 5, y: y + 4, 'text-anchor': 'end'}, shortNumber(share * highest)));
  }
  values.forEach((value, i) => {
    const tall = value / highest * (height - bottom - top);
    const bar = element('rect', {class: 'bar', x: left + i * step, y: height - bottom - tall,
                                 width: Math.max(step * 0.82, 0.6), height: tall});
    bar.append(element('title', {}, `${shortNumber(value)} ${unit}`));
    svg.append(bar);
  });
  svg.append(element('text', {x: left, y: height - 3}, labels[0]));
  svg.append(element('text', {x: width, y: height - 3, 'text-anchor': 'end'}, labels[1]));
  box.replaceChildren(svg);
}

function stageChart(box, stages) {
  const row = 18, width = 320, left = 118;
  const sorted = [...stages].sort((a, b) => b[1] - a[1]).slice(0, 10);
  const highest = Math.max(...sorted.map(stage => stage[1]), 1e-9);
  const svg = element('svg', {viewBox: `0 0 ${width} ${row * sorted.length + 4}`, role: 'img', 'aria-label': 'ms'});
  sorted.forEach(([name, ms], i) => {
    const long = ms / highest * (width - left - 44);
    svg.append(element('text', {x: left - 6, y: i * row + 13, 'text-anchor': 'end'}, name.replaceAll('_', ' ')));
    svg.append(element('rect', {class: 'bar', x: left, y: i * row + 4, width: Math.max(long, 0.6), height: row - 7}));
    svg.append(element('text', {x: left + long + 5, y: i * row + 13}, shortNumber(ms) + ' ms'));
  });
  box.replaceChildren(svg);
}

function fillTable(table, head, rows) {
  table.replaceChildren();
  const add = (cells, tag) => {
    const line = table.insertRow();
    for (const cell of cells) {
      const made = document.createElement(tag);
      made.textContent = cell.text === undefined ? cell : cell.text;
      if (cell.className) made.className = cell.className;
      line.append(made);
    }
  };
  if (head.length) add(head, 'th');
  for (const cells of rows) add(cells, 'td');
}

function showFigures(data) {
  document.getElementById('map-number').textContent = data.map;
  const figures = data.figures;
  document.getElementById('summary').textContent =
    `${figures.images} images of ${data.paths.length} session${data.paths.length === 1 ? '' : 's'}, ` +
    `${data.cloud.count} points, in ${data.unit}`;
  document.getElementById('warnings').replaceChildren(...data.warnings.map(text => {
    const item = document.createElement('li');
    item.textContent = text;
    return item;
  }));
  fillTable(document.getElementById('figures'), [], Object.entries(figures).map(([name, value]) => [name, String(value)]));
  barChart(document.getElementById('tracks'), data.tracks, ['2 views', `${data.tracks.length + 1} and more`], 'points');
  hideUnless(data.errors.length, 'errors') && barChart(document.getElementById('errors'), data.errors, ['first', 'last'], 'px');
  hideUnless(data.views.length, 'views') && barChart(document.getElementById('views'), data.views, ['first', 'last'], 'projections');
  hideUnless(data.stages.length, 'stages') && stageChart(document.getElementById('stages'), data.stages);
  if (!hideUnless(data.merges.length, 'merges')) return;
  fillTable(document.getElementById('merges'),
            ['', 'kind', 'verdict', 'accepted by', 'sessions', 'frames', 'inliers', 'links', 'scale', 'why'],
            data.merges.map(merge => [String(merge.id), merge.kind,
              {text: merge.verdict, className: 'verdict-' + merge.verdict}, merge.accepted_by,
              `${merge.query_session}, ${merge.other_session}`, `${merge.query} – ${merge.other}`, String(merge.inliers), String(merge.links),
              merge.scale_query_from_other.toFixed(3), merge.reason + (merge.warning ? ' · ' + merge.warning : '')]));
}

function hideUnless(isThere, id) {
  document.getElementById(id).closest('.card').hidden = !isThere;
  return isThere;
}
