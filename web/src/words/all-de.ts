/** All words in German: those of the console, and those of messages but for what stands only in a terminal, a report or a score sheet. */
export { de as own } from './de';

export const messages = import.meta.glob<string>(
  [
    '../../../core/words/de/*.ftl',
    '!../../../core/words/*/{cli,drafts,library,newcell,record,report,result,sheet}.ftl',
  ],
  { query: '?raw', import: 'default', eager: true },
);
