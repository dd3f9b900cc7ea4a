import { useSignal } from '@preact/signals';
import type { LogQuestion } from '../api';
import { Choice } from '../ui/choice';
import { MessageText } from '../ui/message-text';
import { Press } from '../ui/press';
import { importWords } from './import-words';
import { answer } from './imports';

/** What has to be answered before the log can go on, the most likely answer chosen already. */
export function Question({ question }: { question: LogQuestion }) {
  const said = importWords.value;
  const chosen = useSignal(question.likely ?? '');
  const asks: Record<string, string> = said.asks;
  return (
    <section class="stack question" aria-label={said.question}>
      <h2>{said.question}</h2>
      <p>
        {said.questionHint} <MessageText message={question.reason} />.
      </p>
      <Choice
        legend={asks[question.key] ?? question.key}
        options={question.choices.map((value) => ({
          value,
          label: choiceName(question.key, value),
          note: value === question.likely ? said.likely : undefined,
        }))}
        chosen={chosen.value}
        choose={(value) => {
          chosen.value = value;
        }}
      />
      <div>
        <Press kind="primary" disabled={chosen.value === ''} act={() => answer(question.key, chosen.value)}>
          {said.answer}
        </Press>
      </div>
    </section>
  );
}

/** What a value of a key is called. */
export function choiceName(key: string, value: string): string {
  const said = importWords.value;
  const named: Record<string, Record<string, string>> = {
    sign: said.sign,
    axes: said.axes,
    inverse: said.inverses,
  };
  return named[key.slice(key.indexOf('.') + 1)]?.[value] ?? value;
}
