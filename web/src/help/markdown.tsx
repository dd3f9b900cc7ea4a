import type { ComponentChildren } from 'preact';
import { route, to } from '../ui/route';

/** Pictures, what stands in brackets and names only pictures, and sentences that name only pictures. */
const PICTURES = [
  /!\[[^\]]*\]\([^)]*\)/g,
  / *\((?:\[[^\]]*\]\(pictures[^)]*\)[,;]?\s*)+\)/g,
  /(?<=[.!?:]\s|\n)(?:[A-Z][\w ,]*:\s)?(?:\[[^\]]*\]\(pictures[^)]*\)[,;]?\s*)+\.(?=\s|$)/g,
];

/** What the manual is written in: headings, paragraphs, lists, tables, code. Its pictures are left out: they show these very screens. */
export function Markdown({ text }: { text: string }) {
  const blocks = PICTURES.reduce((rest, each) => rest.replace(each, ''), text).split(/\n{2,}/);
  return (
    <>
      {join(blocks).map((block) => (
        <Block key={block} text={block} />
      ))}
    </>
  );
}

/** What a heading is called in an address. */
export function slugOf(heading: string): string {
  return heading
    .toLowerCase()
    .replace(/[^\p{L}\p{N}\s-]/gu, '')
    .trim()
    .replace(/\s+/g, '-');
}

/** Code has empty lines in it: its blocks are one. */
function join(blocks: string[]): string[] {
  const found: string[] = [];
  for (const block of blocks.map((each) => each.trim()).filter(Boolean)) {
    const before = found.at(-1);
    if (before !== undefined && isOpenCode(before)) found[found.length - 1] = `${before}\n\n${block}`;
    else found.push(...splitHeadings(block));
  }
  return found;
}

const isOpenCode = (block: string) => block.startsWith('```') && block.split('```').length % 2 === 0;

/** A heading may stand right above what it heads, and a sentence right above a list or a table. */
function splitHeadings(block: string): string[] {
  if (block.startsWith('```')) return [block];
  const begins =
    /\n(?=#{1,6} |```)|(?<=^#{1,6} [^\n]*)\n|\n(?=- |\d+\. |\|)(?<!(?:^|\n)(?:- |\d+\. |\||\s)[^\n]*\n)/;
  return block.split(begins).filter(Boolean);
}

function Block({ text }: { text: string }) {
  const [, marks = '', title = ''] = /^(#{1,6}) (.*)$/.exec(text) ?? [];
  if (marks) return <Heading level={marks.length} title={title} />;
  if (text.startsWith('```')) return <pre>{text.replace(/^```.*\n|\n?```$/g, '')}</pre>;
  if (text.startsWith('|')) return <Table rows={text.split('\n')} />;
  const item = /^(?:- |\d+\. )/;
  if (item.test(text)) {
    const List = text.startsWith('- ') ? 'ul' : 'ol';
    return (
      <List>
        {text.split(/\n(?=- |\d+\. )/).map((each) => (
          <li key={each}>{inline(each.replace(item, ''))}</li>
        ))}
      </List>
    );
  }
  return <p>{inline(text)}</p>;
}

function Heading({ level, title }: { level: number; title: string }) {
  const id = slugOf(title);
  if (level === 1) return <h1 id={id}>{inline(title)}</h1>;
  return level === 2 ? <h2 id={id}>{inline(title)}</h2> : <h3 id={id}>{inline(title)}</h3>;
}

function Table({ rows }: { rows: string[] }) {
  const cells = rows
    .filter((row) => !/^\|[\s|:-]+\|$/.test(row))
    .map((row) =>
      row
        .replace(/^\||\|$/g, '')
        .split(/(?<!\\)\|/)
        .map((cell) => cell.trim().replaceAll('\\|', '|')),
    );
  const [head = [], ...body] = cells;
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached with keys
    <div class="scrolls" tabIndex={0}>
      <table>
        {head.some(Boolean) && (
          <thead>
            <tr>
              {head.map((cell) => (
                <th key={cell} scope="col">
                  {inline(cell)}
                </th>
              ))}
            </tr>
          </thead>
        )}
        <tbody>
          {body.map((row) => (
            <tr key={row.join('|')}>
              {row.map((cell, k) => (
                <td key={`${k} ${cell}`}>{inline(cell)}</td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const INLINE = /`([^`]+)`|\*\*([^*]+)\*\*|\*([^*]+)\*|\[([^\]]+)\]\(([^)]+)\)/g;

/** Code, stress and links within a line. */
function inline(text: string): ComponentChildren[] {
  const found: ComponentChildren[] = [];
  let end = 0;
  for (const match of text.matchAll(INLINE)) {
    found.push(text.slice(end, match.index));
    end = match.index + match[0].length;
    const [, code, strong, stress, label, address] = match;
    if (code) found.push(<code>{code}</code>);
    else if (strong) found.push(<b>{inline(strong)}</b>);
    else if (stress) found.push(<em>{stress}</em>);
    else found.push(link(label ?? '', address ?? ''));
  }
  return [...found, text.slice(end)];
}

/** Other pages of the manual are here; what stands only beside the sources is named and not linked. */
function link(label: string, address: string): ComponentChildren {
  const [, other, heading] = /^(?:([\w-]+)\.md)?(?:#(.*))?$/.exec(address) ?? [];
  const page = other ?? (heading && route.value[1]);
  if (page) return <a href={to('manual', page, ...(heading ? [heading] : []))}>{inline(label)}</a>;
  return /^https:/.test(address) ? (
    <a href={address} rel="noreferrer" target="_blank">
      {inline(label)}
    </a>
  ) : (
    inline(label)
  );
}
