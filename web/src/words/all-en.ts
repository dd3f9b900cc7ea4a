/** All words in English: those of the console, and those of messages but for what stands only in a terminal, a report or a score sheet. */
export { en as own } from './en';

export const messages = import.meta.glob<string>(
  [
    '../../../core/words/en/*.ftl',
    '!../../../core/words/*/{cli,drafts,library,newcell,record,report,result,sheet}.ftl',
  ],
  { query: '?raw', import: 'default', eager: true },
);
