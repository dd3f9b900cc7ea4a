import type UPlot from 'uplot';
import { type Line, legendOf, nameOf } from './plot-line';

const MARGIN_PX = 12;
const HEAD_PX = 34;
const BASE_PX = 30;
const KEY_PX = 22;
const FONT = '600 17px system-ui, sans-serif';

/** A plot's numbers as comma-separated values: dots as decimal marks, whatever the language; moments as ISO 8601. */
export function writeCsv(data: UPlot.AlignedData, lines: Line[], since: 'run' | '1970', unit: string): Blob {
  const [times, ...rows] = data;
  const heads = lines.map((line) => (unit ? `${nameOf(line)} (${unit})` : nameOf(line)));
  const time = (t_s: number) => (since === 'run' ? String(t_s) : new Date(1000 * t_s).toISOString());
  const body = Array.from(times, (t_s, k) =>
    [time(t_s), ...rows.map((row) => row[k] ?? '')].map(String).join(','),
  );
  const first = [since === 'run' ? 'time (s)' : 'time', ...heads].map(quoted).join(',');
  return new Blob([`${[first, ...body].join('\r\n')}\r\n`], { type: 'text/csv' });
}

function quoted(text: string): string {
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

/** A plot as it is drawn, with its title and legend above it, on the ground that it stands on. */
export async function drawPng(plot: UPlot, title: string, lines: Line[]): Promise<Blob> {
  const from = plot.ctx.canvas;
  const scale = devicePixelRatio;
  const picture = document.createElement('canvas');
  picture.width = from.width + 2 * MARGIN_PX * scale;
  picture.height = from.height + (HEAD_PX + 2 * MARGIN_PX) * scale;
  const context = picture.getContext('2d');
  if (context === null) throw new Error('no canvas to draw on');
  const look = getComputedStyle(plot.root.closest('.plot') ?? plot.root);
  context.fillStyle = look.backgroundColor;
  context.fillRect(0, 0, picture.width, picture.height);
  context.scale(scale, scale);
  context.fillStyle = look.color;
  context.font = FONT;
  context.fillText(title, MARGIN_PX, BASE_PX);
  drawLegend(context, plot, lines, 2 * MARGIN_PX + context.measureText(title).width);
  context.drawImage(from, MARGIN_PX, HEAD_PX + MARGIN_PX, from.width / scale, from.height / scale);
  return new Promise((done, failed) => {
    picture.toBlob((made) => (made === null ? failed(new Error('no picture')) : done(made)), 'image/png');
  });
}

/** The lines that are shown and have a place in the legend, side by side. */
function drawLegend(context: CanvasRenderingContext2D, plot: UPlot, lines: Line[], begin_px: number): void {
  const ink = context.fillStyle;
  let x = begin_px;
  for (const line of legendOf(lines)) {
    const index = lines.indexOf(line) + 1;
    const { show, stroke } = plot.series[index] ?? {};
    if (show === false) continue;
    context.fillStyle = typeof stroke === 'function' ? (stroke(plot, index) ?? ink) : ink;
    const parts = line.dashed ? [0, 2] : [0, 1, 2];
    for (const part of parts) context.fillRect(x + (part * KEY_PX) / 3, BASE_PX - 8, KEY_PX / 3, 3);
    context.fillStyle = ink;
    context.fillText(line.label, x + KEY_PX + 6, BASE_PX);
    x += KEY_PX + 6 + context.measureText(line.label).width + MARGIN_PX;
  }
}
