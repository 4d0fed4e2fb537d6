// SPDX-License-Identifier: MIT
// `npm run options`: makes everything about options and reports that is not C++ of what the native
// command line says of them (`kdmanifold --describe`; the tables are in src/include/kdmanifold).
// The files are committed; a test says whether they are current.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { builders } from './build.mjs';
import { output, root } from './run.mjs';

const head = (text) => `// SPDX-License-Identifier: MIT
// ${text} Made by scripts/generate-options.mjs, not by hand.
`;

/** Everything that is made, by its path in the repository. `page` is docs/options.md as it is. */
export async function generate(description, page) {
  // Here, not at the top: set-up may just have installed it.
  const { format } = await import('prettier');
  const { build, extract, reduction, reduce, simplify, analyze, files, report, solids } =
    description.options;
  const typescript = (text) =>
    format(text, { parser: 'typescript', printWidth: 100, singleQuote: true });
  return {
    'web/src/options.ts': await typescript(
      [
        head('Options: types, legal values.'),
        `import type { OptionTable } from './option-spec.js';\n`,
        optionInterface('BuildOptions', 'How a mesh becomes a grid', build),
        optionInterface('ExtractOptions', 'How a grid becomes a mesh', extract),
        optionInterface('ReductionOptions', 'How a mesh gets fewer triangles', reduction),
        optionInterface('ReduceOptions', 'How far a mesh is reduced', reduce),
        optionInterface('SimplifyOptions', 'How far a grid is simplified', simplify),
        optionInterface('AnalyzeOptions', 'What `KdManifold.analyze` looks for', analyze),
        optionTable('buildOptions: OptionTable<BuildOptions>', build),
        optionTable('extractOptions: OptionTable<ExtractOptions>', extract),
        optionTable('reductionOptions: OptionTable<ReductionOptions>', reduction),
        optionTable('reduceOptions: OptionTable<ReduceOptions>', reduce),
        optionTable('simplifyOptions: OptionTable<SimplifyOptions>', simplify),
        optionTable('analyzeOptions: OptionTable<AnalyzeOptions>', analyze),
      ].join('\n'),
    ),
    'web/src/reports.ts': await typescript(
      [
        head('Types of reports, keys of their parts.'),
        `import type { OwnFloat64Array, OwnUint32Array } from './outside-types.js';\n`,
        ...Object.entries(description.reports).map(([name, report]) =>
          reportInterface(name, report),
        ),
        keyList('outputKeys', keysOf(description.reports.OutputReport), 'In order'),
        keyList('checkKeys', description.check, 'What --check looks for'),
        keyList('defectKeys', description.defects, 'What --stats counts'),
        partKeys(description.reports.MeshPart),
      ].join('\n'),
    ),
    'web/src/cli/table.ts': await typescript(
      [
        head('The command line.'),
        `import type { OptionSpec } from '../option-spec.js';\n`,
        optionTable('fileOptions: Record<string, OptionSpec>', files),
        optionTable('reportOptions: Record<string, OptionSpec>', report),
        optionTable('solidOptions: Record<string, OptionSpec>', solids),
        `/** What --help prints. */\nexport const helpText = [\n${description.help
          .split('\n')
          .map((line) => `  ${JSON.stringify(line)},`)
          .join('\n')}\n].join('\\n');`,
      ].join('\n'),
    ),
    'docs/options.md': withTable(page, [...build, ...extract, ...reduction]),
  };
}

const sentence = (text) =>
  text === undefined
    ? ''
    : `${text[0].toUpperCase()}${text.slice(1)}${/[.:]$/.test(text) ? '' : '.'}`;

// Unit and range, as they complete the help.
function measure({ unit, least, most, below }) {
  const ends = below ?? most;
  const range =
    ends === undefined ? '' : `from ${least} to ${below === undefined ? '' : 'below '}${ends}`;
  if (unit === undefined) return range && `, ${range}`;
  return `, in ${unit}${range && ` ${range}`}`;
}

// What stands if the option is left out, and what 0 means. Words tell their default themselves.
function standard({ type, default: value, zero, unset }) {
  if (type === 'choice') return '';
  if (unset !== undefined) return `Left out: ${unset}.`;
  if (zero !== undefined && value === 0) return `0, the default: ${zero}.`;
  return `Default ${value}.${zero === undefined ? '' : ` 0: ${zero}.`}`;
}

const joined = (...parts) => parts.filter(Boolean).join(' ');

/** A documentation comment, broken at 100 columns; `lines` are paragraphs or points of a list. */
function comment(lines, indent) {
  const broken = lines.flatMap((line) => {
    const rows = [''];
    for (const word of line.split(' ')) {
      const row = rows.at(-1);
      if (row !== '' && indent.length + 4 + row.length + word.length > 100) {
        rows.push(line.startsWith('- ') ? `  ${word}` : word);
      } else {
        rows[rows.length - 1] = row === '' ? word : `${row} ${word}`;
      }
    }
    return rows;
  });
  if (broken.length === 1 && indent.length + broken[0].length + 7 <= 100) {
    return `${indent}/** ${broken[0]} */`;
  }
  return [`${indent}/**`, ...broken.map((row) => `${indent} * ${row}`), `${indent} */`].join('\n');
}

function optionInterface(name, help, options) {
  const members = options.map((option) => {
    const { words = [] } = option;
    let text = joined(sentence(option.help + measure(option)), option.details, standard(option));
    const points = words.map(
      ({ word, help }) => `- \`${word}\`${word === option.default ? ' (default)' : ''}: ${help}`,
    );
    if (points.length > 0) text = text.replace(/\.$/, ':');
    return `${comment([text, ...points], '  ')}\n  ${option.name}?: ${optionType(option)};`;
  });
  return `${comment([sentence(help)], '')}\nexport interface ${name} {\n${members.join('\n')}\n}\n`;
}

function optionType({ type, words }) {
  if (type === 'choice') return words.map(({ word }) => `'${word}'`).join(' | ');
  if (type === 'numbers') return 'number | readonly number[]';
  if (type === 'box') return 'readonly number[]';
  return type === 'integer' ? 'number' : type;
}

function optionTable(declaration, options) {
  const rows = options.map((option) => {
    const { name, flag, type, words, shortName, repeats, least, most, below } = option;
    const spec = { flag, kind: type, words: words?.map(({ word }) => word), shortName, repeats };
    Object.assign(spec, { least, most, below, default: option.default });
    return `  ${name}: ${JSON.stringify(spec)},`;
  });
  return `/** @internal */\nexport const ${declaration} = {\n${rows.join('\n')}\n};\n`;
}

const reportTypes = {
  integer: 'number',
  number: 'number',
  boolean: 'boolean',
  'integer or null': 'number | null',
  box: '{ min: Float64Array; max: Float64Array }',
  list: 'OwnUint32Array',
  points: 'OwnFloat64Array',
  Deviation: 'Deviation',
  lists: 'OwnUint32Array[]',
  'MeshPart list': 'MeshPart[]',
  MeshReport: 'MeshReport',
};

function reportInterface(name, { help, keys }) {
  const members = keys.map((key) => {
    const unit = key.unit === undefined ? '' : `In ${key.unit}.`;
    return `${comment([joined(sentence(key.help), unit)], '  ')}\n  ${key.name}: ${reportTypes[key.type]};`;
  });
  return `${comment([sentence(help)], '')}\nexport interface ${name} {\n${members.join('\n')}\n}\n`;
}

const keysOf = ({ keys }) => keys.map(({ name }) => name);

const keyList = (name, keys, help) =>
  `/** @internal ${help}. */\nexport const ${name} = ${JSON.stringify(keys)} as const;\n`;

const partKeys = ({ keys }) =>
  `/** @internal The fields of \`MeshPart\` in order, and their types. */
export const partKeys = ${JSON.stringify(keys.map(({ name, type }) => [name, type]))} as const;\n`;

const begin = '<!-- Made by `npm run options`, not by hand. -->';
const end = '<!-- End of what is made. -->';

function withTable(page, options) {
  const from = page.indexOf(begin);
  const to = page.indexOf(end);
  if (from < 0 || to < from) throw new Error(`docs/options.md: '${begin}' or '${end}' is missing`);
  const rows = options.map((option) => {
    const { name, flag, words = [], unset } = option;
    const typed = flag.startsWith('--no-') ? ` (\`${flag}\`)` : '';
    const shown = option.type === 'choice' ? `\`${option.default}\`` : (unset ?? option.default);
    const zero = option.zero === undefined ? '' : `0: ${option.zero}.`;
    const meaning = [
      sentence(option.help + measure(option)),
      zero,
      ...words.map(({ word, help }) => `\`${word}\`: ${help}.`),
    ];
    return `| \`${name}\`${typed} | ${shown} | ${joined(...meaning)} |`;
  });
  const table = [
    '| option (`--name` on the command line) | default | meaning |',
    '| --- | --- | --- |',
    ...rows,
  ];
  return `${page.slice(0, from + begin.length)}\n\n${table.join('\n')}\n\n${page.slice(to)}`;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  builders.native();
  const program = `${root}/build/native/src/cli/kdmanifold`;
  const description = JSON.parse(output(program, ['--describe']));
  const made = await generate(description, readFileSync(`${root}/docs/options.md`, 'utf8'));
  for (const [path, text] of Object.entries(made)) writeFileSync(`${root}/${path}`, text);
}
