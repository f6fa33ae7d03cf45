import { parentPort } from 'node:worker_threads';
import { answers } from './answers.mjs';
import * as oracle from './index.mjs';

parentPort.on('message', answers(oracle, (said) => parentPort.postMessage(said)));
