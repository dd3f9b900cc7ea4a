import type { FunctionComponent } from 'preact';
import type { Role } from '../api';
import { may } from '../session/session';
import { AccountSection } from './account-section';
import type { AdminWords } from './admin-words';
import { AuditSection } from './audit-section';
import { ConnectionsSection } from './connections-section';
import { KeySection } from './key-section';
import { PeopleSection } from './people-section';
import { ServiceSection } from './service-section';
import { WebhookSection } from './webhook-section';

export type SectionName = keyof AdminWords['sections'];

interface Section {
  Section: FunctionComponent;
  /** Who may see it, as in the service's table of authority; empty for everybody. */
  roles: Role[];
}

/** By the second piece of the address, in the order in which they are shown. */
export const SECTIONS: Record<SectionName, Section> = {
  account: { Section: AccountSection, roles: [] },
  people: { Section: PeopleSection, roles: ['admin'] },
  keys: { Section: KeySection, roles: ['admin'] },
  webhooks: { Section: WebhookSection, roles: ['admin'] },
  audit: { Section: AuditSection, roles: ['admin', 'engineer'] },
  connections: { Section: ConnectionsSection, roles: ['admin', 'engineer'] },
  service: { Section: ServiceSection, roles: ['admin', 'engineer'] },
};

/** Whether who is signed in may see it. */
export const isOpen = (name: SectionName) => {
  const { roles } = SECTIONS[name];
  return roles.length === 0 || may(...roles);
};

export const isSection = (name: string): name is SectionName => Object.hasOwn(SECTIONS, name);
