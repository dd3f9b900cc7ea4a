const MOST_LETTERS = 60;

/**
 * The name of a file without its ending: what it is, of what, with which tool, on which day (UTC), in plain letters that every system
 * takes; as the service names its own.
 */
export function nameFile(parts: readonly (string | null | undefined)[], when: string): string {
  const words = parts.flatMap((part) => {
    const plain = (part ?? '').normalize('NFKD').replace(/[^ -~]/g, '');
    const word = plain.replace(/[^A-Za-z0-9_.]+/g, '_').replace(/^[_.]+|[_.]+$/g, '');
    return word ? [word.slice(0, MOST_LETTERS)] : [];
  });
  return [...words, when.slice(0, 10)].join('-');
}

/** Saves something that this page has made. */
export function saveFile(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  URL.revokeObjectURL(link.href);
}
