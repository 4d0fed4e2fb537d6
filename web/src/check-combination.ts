// SPDX-License-Identifier: MIT
// Finds options that have no effect beside the others, as src/options/check_options.cpp does.
import type { OptionSpec } from './option-spec.js';
import { buildOptions, extractOptions, reductionOptions } from './options.js';
import type { BuildOptions, ExtractOptions, ReductionOptions } from './types.js';

/** An option without effect, and when it has one; names of other options stand in backticks. */
export interface Useless {
  name: string;
  when: string;
}

type Rule<Options> = [keyof Options & string, (options: Options) => boolean, string];

const counts = ({ strategy }: BuildOptions): boolean =>
  strategy === 'median' || strategy === 'uniform';
const noRepair = ({ inside = 'repair' }: BuildOptions): boolean => inside !== 'repair';
const noSolid = ({ inside = 'repair' }: BuildOptions): boolean =>
  inside !== 'repair' && inside !== 'positive';
const hasCells = ({ cells = 0 }: BuildOptions): boolean => cells > 0;
const insteadOfCells = 'not together with `cells`';
const byTolerance = 'only with `strategy` adaptive, octree or feature';

const buildRules: Rule<BuildOptions>[] = [
  [
    'cells',
    ({ strategy }) => strategy !== 'octree' && strategy !== 'uniform',
    'only with `strategy` octree or uniform',
  ],
  ['depth', hasCells, insteadOfCells],
  ['tolerance', hasCells, insteadOfCells],
  ['relativeTolerance', hasCells, insteadOfCells],
  ['relativeTolerance', ({ tolerance = 0 }) => tolerance > 0, 'not together with `tolerance`'],
  ['tolerance', counts, byTolerance],
  ['relativeTolerance', counts, byTolerance],
  ['windingThreshold', noRepair, 'only with `inside` repair'],
  ['largestHole', noRepair, 'only with `inside` repair'],
  [
    'largestHole',
    ({ thicken = 0, thickenWhat }) => thicken > 0 && thickenWhat !== 'sheets',
    'not together with `thicken`, which leaves no holes',
  ],
  ['thickenWhat', ({ thicken = 0 }) => thicken === 0, 'only with `thicken`'],
  [
    'thickenWhat',
    (options) => options.thickenWhat === 'sheets' && noRepair(options),
    'sheets only with `inside` repair',
  ],
  [
    'thickenWhat',
    ({ thickenWhat, windingThreshold = 0 }) => thickenWhat === 'sheets' && windingThreshold > 0,
    'not sheets together with `windingThreshold`',
  ],
  ['minimumThickness', counts, byTolerance],
  ['minimumGap', counts, byTolerance],
  ['minimumThickness', hasCells, insteadOfCells],
  ['minimumGap', hasCells, insteadOfCells],
  ['minimumThickness', noSolid, 'only with `inside` repair or positive'],
  ['minimumGap', noSolid, 'only with `inside` repair or positive'],
  [
    'pairing',
    ({ pairing, inside }) => inside === 'sheet' && (pairing === 'inside' || pairing === 'outside'),
    'only trace or hermite with `inside` sheet',
  ],
];

const extractRules: Rule<ExtractOptions>[] = [
  [
    'strict',
    ({ quads = false, strict }) => quads && strict === 'embedded',
    'not embedded together with `quads`',
  ],
  ['linkError', ({ quads = false }) => quads, 'not together with `quads`'],
  ['dropHandles', ({ quads = false }) => quads, 'not together with `quads`'],
  ['dropHandles', ({ strict }) => strict === 'off', 'not together with `strict` off'],
  ['creaseAngle', ({ normals = false }) => !normals, 'only with `normals`'],
];

const withoutSimplify = ({ simplify = 0 }: ReductionOptions): boolean => simplify === 0;

const reductionRules: Rule<ReductionOptions>[] = [
  ['removeMaterial', withoutSimplify, 'only with `simplify`'],
  ['addMaterial', withoutSimplify, 'only with `simplify`'],
];

function find<Options extends object>(
  rules: Rule<Options>[],
  options: Options,
  isGiven: (name: keyof Options & string) => boolean,
): Useless | undefined {
  const rule = rules.find(([name, isUseless]) => isGiven(name) && isUseless(options));
  return rule && { name: rule[0], when: rule[2] };
}

// Who hands all options over, as a form does, hands over defaults too: these do no harm.
const differs =
  (options: Record<string, unknown>, table: Record<string, OptionSpec>) =>
  (name: string): boolean => {
    const spec = table[name];
    return (
      options[name] !== undefined &&
      options[name] !== (spec && 'default' in spec ? spec.default : undefined)
    );
  };

/** Returns the first option of `buildGrid` that differs from its default and has no effect. */
export const uselessOfBuild = (
  options: BuildOptions,
  isGiven: (name: string) => boolean = differs({ ...options }, buildOptions),
): Useless | undefined => find(buildRules, options, isGiven);

/** Returns the first option of `Grid.extract` that differs from its default and has no effect. */
export const uselessOfExtract = (
  options: ExtractOptions,
  isGiven: (name: string) => boolean = differs({ ...options }, extractOptions),
): Useless | undefined => find(extractRules, options, isGiven);

/** Returns the first option of reduction that differs from its default and has no effect. */
export const uselessOfReduction = (
  options: ReductionOptions,
  isGiven: (name: string) => boolean = differs({ ...options }, reductionOptions),
): Useless | undefined => find(reductionRules, options, isGiven);

// What excludes reduction, as src/make/reduction_rule.cpp finds it.
function obstacle(build: BuildOptions, extract: ExtractOptions): string | undefined {
  const { strategy, tolerance = 0, relativeTolerance, cells = 0 } = build;
  if (extract.quads) return '`quads`';
  if (extract.strict === 'off') return '`strict` off';
  if (strategy === 'median' || strategy === 'uniform') return `\`strategy\` ${strategy}`;
  if (cells > 0) return '`cells`';
  return tolerance === 0 && relativeTolerance === 0 ? '`relativeTolerance` 0' : undefined;
}

/** Returns the option that asks for reduction beside one that excludes it. */
export function uselessReduction(
  { reduce, targetTriangles }: ReductionOptions,
  build: BuildOptions,
  extract: ExtractOptions,
): Useless | undefined {
  const numbered = targetTriangles !== undefined;
  if (numbered && reduce === false) {
    return { name: 'targetTriangles', when: 'not together with `reduce` false' };
  }
  const wish = numbered ? 'targetTriangles' : reduce ? 'reduce' : undefined;
  const excludes = obstacle(build, extract);
  return wish && excludes ? { name: wish, when: `not together with ${excludes}` } : undefined;
}

/** Says whether a result will be reduced, of options that do not exclude each other. */
export const isReduced = (
  { reduce = true }: ReductionOptions,
  build: BuildOptions,
  extract: ExtractOptions,
): boolean => reduce && obstacle(build, extract) === undefined;
