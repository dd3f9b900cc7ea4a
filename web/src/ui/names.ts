/** Who somebody is, as people call them: "account:anna" is anna. */
export function nameOf(who: string): string {
  return who.replace(/^account:/, '');
}
