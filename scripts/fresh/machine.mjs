// SPDX-License-Identifier: MIT
// A bare Debian 12 in a folder. Commands run in it in namespaces of their own: when the first process
// of one ends, or is killed, all of its children and mounts are gone with it.
import { spawn, spawnSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, renameSync, rmSync } from 'node:fs';
import { homedir } from 'node:os';
import { dirname, join } from 'node:path';
import { output, root as project } from '../run.mjs';

const release = 'bookworm';

/** What reaches the network depends on: proxies, certificates, where npm gets its packages. */
const networkVariables =
  /^((https?|ftp|no|all)_proxy|NODE_EXTRA_CA_CERTS|(CURL|REQUESTS)_CA_BUNDLE|SSL_CERT_(FILE|DIR)|GIT_SSL_CAINFO|npm_config_(registry|cafile|(https?_)?proxy|noproxy))$/i;
const network = Object.fromEntries(
  Object.entries(process.env).filter(([name]) => networkVariables.test(name)),
);

const removeTree = (path) => rmSync(path, { recursive: true, force: true, maxRetries: 3 });

/** The smallest Debian with git, made once. */
function base() {
  const folder = `${project}/build/fresh/base`;
  if (existsSync(folder)) return folder;
  const half = `${folder}.half`;
  removeTree(half);
  mkdirSync(dirname(half), { recursive: true });
  // In a namespace of its own: what it mounts is gone with it, even if it is interrupted.
  const wanted = ['--variant=minbase', '--include=git,ca-certificates', release, half, mirror()];
  output('unshare', ['--mount', 'debootstrap', ...wanted.filter(Boolean)]);
  renameSync(half, folder);
  return folder;
}

/** Where this machine gets Debian's packages from. */
function mirror() {
  const format = ['--format', '$(RELEASE) $(COMPONENT) $(REPO_URI)', 'Created-By: Packages'];
  const lines = output('apt-get', ['indextargets', ...format]).split('\n');
  const wanted = `${release} main `;
  return lines.find((line) => line.startsWith(wanted))?.slice(wanted.length) ?? '';
}

export class Machine {
  constructor(name) {
    this.root = `${project}/build/fresh/${name}`;
  }

  create() {
    this.remove();
    output('cp', ['--archive', '--reflink=auto', base(), this.root]);
    this.#copyNetworkSettings();
  }

  /** How this machine gets packages: apt's settings and keys, certificates, names of hosts. */
  #copyNetworkSettings() {
    removeTree(join(this.root, 'etc/apt'));
    this.#copy('/etc/apt', '/usr/share/keyrings', '/usr/local/share/ca-certificates');
    this.#copy('/etc/hosts', '/etc/resolv.conf', ...Object.values(network));
  }

  /** npm's settings, for a Node that lies below `prefix` there. */
  copyNpmSettings(prefix) {
    const setting = (name) => output('npm', ['config', 'get', name], { cwd: '/' }).trim();
    this.#copy(setting('cafile'));
    this.#copyFile(setting('globalconfig'), join(prefix, 'etc/npmrc'));
    this.#copyFile(join(homedir(), '.npmrc'), '/root/.npmrc');
  }

  /** Files and folders to the same places; what is no path, or not there, is passed over. */
  #copy(...paths) {
    const there = paths.filter((path) => path.startsWith('/') && existsSync(path));
    const careful = ['--archive', '-H', '--parents', '--remove-destination'];
    if (there.length > 0) output('cp', [...careful, ...there, this.root]);
  }

  #copyFile(from, to) {
    if (!existsSync(from)) return;
    mkdirSync(dirname(join(this.root, to)), { recursive: true });
    copyFileSync(from, join(this.root, to));
  }

  /** The version of a package there, or nothing. */
  versionOf(name) {
    const query = [`--root=${this.root}`, '--show', '--showformat', '${Version}', name];
    return spawnSync('dpkg-query', query, { encoding: 'utf8' }).stdout;
  }

  /** Runs a command to its end; one that fails is an error. */
  demand(command) {
    const [name, args, options] = this.#within(command);
    const { status, stderr } = spawnSync(name, args, { ...options, encoding: 'utf8' });
    if (status !== 0) throw new Error(`${command.join(' ')}: ${stderr}`);
  }

  /** Starts a command in a process group of its own. */
  start(command, options) {
    const [name, args, common] = this.#within(command, options.env);
    return spawn(name, args, { ...common, stdio: options.stdio, detached: true });
  }

  #within(command, env = {}) {
    const script = `
      mount -t proc proc "$0/proc" && mount -t sysfs -o ro sysfs "$0/sys" &&
      mount --rbind /dev "$0/dev" && chroot "$0" "$@"`;
    const clean = {
      HOME: '/root',
      PATH: '/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin',
      ...network,
      ...env,
    };
    return [
      'unshare',
      ['--mount', '--pid', '--fork', '--kill-child', 'sh', '-c', script, this.root, ...command],
      { env: clean },
    ];
  }

  remove() {
    removeTree(this.root);
  }
}
