// SPDX-License-Identifier: MIT
// The Node that runs this, npm with it, put onto a bare machine in the two ways in which people get
// it: as a Debian package, and unpacked by hand.
import { cpSync, existsSync, mkdirSync, symlinkSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { output } from '../run.mjs';

const prefix = dirname(dirname(process.execPath));
const version = process.versions.node;

/** Each brings Node into the root and returns the prefix below which it lies there. */
export const waysOfNode = {
  /** NodeSource's: a package that has Debian's name and brings npm. */
  package(machine) {
    const folder = join(machine.root, 'tmp/nodejs');
    unpack(join(folder, 'usr'));
    mkdirSync(join(folder, 'DEBIAN'));
    writeFileSync(join(folder, 'DEBIAN/control'), control());
    output('dpkg-deb', ['--build', '--root-owner-group', '-Zgzip', '-z1', folder]);
    machine.demand(['dpkg', '--install', '/tmp/nodejs.deb']);
    machine.demand(['rm', '-r', '/tmp/nodejs', '/tmp/nodejs.deb']);
    return '/usr';
  },
  /** The archive of nodejs.org. Emscripten then brings Debian's own, older nodejs beside it. */
  unpacked(machine) {
    unpack(join(machine.root, 'usr/local'));
    return '/usr/local';
  },
};

function unpack(target) {
  const npm = 'lib/node_modules/npm';
  if (!existsSync(join(prefix, npm))) {
    throw new Error(`no ${npm} in ${prefix}: this needs a Node that comes with npm`);
  }
  mkdirSync(join(target, 'bin'), { recursive: true });
  cpSync(process.execPath, join(target, 'bin/node'));
  cpSync(join(prefix, npm), join(target, npm), { recursive: true, verbatimSymlinks: true });
  for (const name of ['npm', 'npx']) {
    symlinkSync(`../${npm}/bin/${name}-cli.js`, join(target, 'bin', name));
  }
}

const control = () => `Package: nodejs
Version: ${version}-1fresh1
Architecture: ${output('dpkg', ['--print-architecture']).trim()}
Multi-Arch: allowed
Maintainer: kdmanifold <root@localhost>
Depends: libc6, libstdc++6, ca-certificates
Provides: nodejs-dev, nodejs-doc, nodejs-legacy, npm
Conflicts: nodejs-dev, nodejs-doc, nodejs-legacy, npm
Replaces: nodejs-dev, nodejs-doc, nodejs-legacy, npm
Description: the Node that runs the tests, as a package of its own
`;
