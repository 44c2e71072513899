'use strict';
// The report of one map. The data are described in ReportData.h.
const data = JSON.parse(document.getElementById('data').textContent);
const element = id => document.getElementById(id);

function add(parent, tag, text, className) {
  const child = document.createElement(tag);
  if (text !== undefined) child.textContent = text;
  if (className) child.className = className;
  parent.appendChild(child);
  return child;
}

function swatch(parent, color) {
  add(parent, 'span', undefined, 'swatch').style.background = color;
}

function meter(parent, share) {
  add(add(parent, 'span', undefined, 'meter'), 'i').style.width = 100 * Math.min(1, share) + '%';
}

window.addEventListener('error', event => {
  document.body.dataset.error = event.message;
  element('hint').textContent = 'The 3D view cannot be drawn (' + event.message + '): it needs WebGL.';
});

const nameOf = object => object.category + ' ' + object.id;
const percent = share => Math.round(100 * share) + ' %';

// ---- the page around the 3D view -----------------------------------------------------------------

function fillPage() {
  element('title').textContent = data.title;
  for (const [name, value] of data.summary) {
    const pair = add(element('summary'), 'div');
    add(pair, 'dt', name);
    add(pair, 'dd', value);
  }
  for (const id of ['evaluation', 'timing']) {
    element(id).hidden = !data[id];
    element(id).querySelector('pre').textContent = data[id];
  }
  for (const picture of data.pictures) {
    const figure = add(element('pictures').querySelector('div'), 'figure');
    add(figure, 'img').src = 'data:image/png;base64,' + picture.png;
    figure.firstChild.alt = picture.title;
    add(figure, 'figcaption', picture.title);
    figure.addEventListener('click', () => figure.classList.toggle('large'));
  }
}

// ---- table ----------------------------------------------------------------------------------------

const COLUMNS = [
  {title: '', value: o => o.color, show: (cell, o) => swatch(cell, o.color)},
  {title: 'object', text: true, value: o => nameOf(o)},
  {title: 'probability', value: o => o.probability, show: (cell, o) => { meter(cell, o.probability); add(cell, 'span', percent(o.probability)); }},
  {title: 'category entropy', value: o => o.entropy, digits: 2},
  {title: 'voxel entropy', value: o => o.doubt, digits: 2},
  {title: 'seen', value: o => o.observations, digits: 0},
  {title: 'voxels', value: o => o.voxels, digits: 0},
  {title: 'size [m]', value: o => Math.max(...o.box.size), show: (cell, o) => { cell.textContent = o.box.size.map(s => s.toFixed(1)).join(' x '); }}
];
let sorting = {column: COLUMNS[6], ascending: false};

function fillTable() {
  const table = element('table'), body = table.tBodies[0];
  const wanted = element('filter').value.trim().toLowerCase();
  const {column, ascending} = sorting;
  const rows = data.instances.filter(o => nameOf(o).toLowerCase().includes(wanted));
  const sign = ascending ? 1 : -1;
  rows.sort((a, b) => {
    const [x, y] = [column.value(a), column.value(b)];
    return sign * (column.text ? x.localeCompare(y, undefined, {numeric: true}) : x < y ? -1 : x > y ? 1 : 0);
  });
  body.textContent = '';
  for (const object of rows) {
    const row = body.insertRow();
    row.object = object;
    row.classList.toggle('chosen', object === chosen);
    row.addEventListener('click', () => choose(object === chosen ? null : object, true));
    for (const c of COLUMNS) {
      const cell = row.insertCell();
      if (c.text) cell.className = 'text';
      if (c.show) c.show(cell, object);
      else cell.textContent = c.text ? c.value(object) : c.value(object).toFixed(c.digits);
    }
  }
  for (const head of table.tHead.rows[0].cells) {
    head.classList.toggle('sorted', head.column === column);
    head.classList.toggle('up', ascending);
  }
}

function makeTable() {
  const head = element('table').tHead.insertRow();
  for (const column of COLUMNS) {
    const cell = add(head, 'th', column.title, column.text ? 'text' : '');
    cell.column = column;
    cell.addEventListener('click', () => {
      sorting = {column, ascending: sorting.column === column ? !sorting.ascending : Boolean(column.text)};
      fillTable();
    });
  }
  element('filter').addEventListener('input', fillTable);
  fillTable();
}
