import type { KeyInput, RateInput, SceneInput } from './task_values.js';
type Flag = boolean | 'true' | 'false';
/** As the command has it, with its unit where it has one: `0.1deg`. */
type Text = string | number;
/** What each task takes. */
export interface Tasks {
    /** A noisy recording as a smooth motion with rates. */
    smooth: {
        inputs: {
            /** The recording, or a skeleton with its clips. */
            recording: KeyInput | SceneInput;
            /** The rates of a gyro with a clock of its own. */
            gyro?: RateInput | undefined;
        };
        options: {
            /** Cut-off frequency 1/(2 pi tau) [Hz] instead of the smoothing time: half of a motion at it is left. */
            cutoff?: Text | Flag | undefined;
            /** At most so many at work; 0: one per core. */
            threads?: Text | Flag | undefined;
            /** Rate whose squared integral is kept small. */
            penalty?: 'acceleration' | 'jerk' | undefined;
            /** Standard deviation of the noise of the orientations, per axis. */
            noise?: Text | undefined;
            /** The time within which the correlation of the noise of the orientations falls to 1/e. */
            noise_time?: Text | undefined;
            /** Smoothing time tau; a longer one smooths more. */
            smoothing_time?: Text | undefined;
            /** How much samples far from the curve count: robust rejects outliers, l2 trusts every sample. */
            loss?: 'robust' | 'l2' | 'huber' | 'tukey' | undefined;
            /** Use wx, wy, wz as the rates of a gyro, whose bias is estimated. */
            gyro?: Flag | undefined;
            /** Standard deviation of the noise of the gyro's rates, per axis. */
            gyro_noise?: Text | undefined;
            /** By how much the stamps of the gyro are late. */
            gyro_offset?: Text | undefined;
            /** The bias of the gyro. */
            gyro_bias?: 'constant' | 'drifting' | undefined;
            /** Standard deviation of the noise of the positions, per axis. */
            position_noise?: Text | undefined;
            /** Smooth nothing across intervals longer than this. */
            gap?: Text | undefined;
            /** Let the smoothing time of the orientations vary in time, where that predicts the samples clearly better. */
            adapt?: Flag | undefined;
            /** Of a skeleton: bridge runs of frames in which joints jump away and back while the others go on. */
            runs?: Flag | undefined;
            /** Of a skeleton: joints that stay where they stand on the ground, or auto for those in which its legs end. */
            keep_contacts?: Text | undefined;
            /** Add one standard deviation of every orientation and rate, along the axes of the body. */
            sigma?: Flag | undefined;
        };
    };
    /** The tensions that make a curve smoothest, or nearest to a recording. */
    tune: {
        inputs: {
            /** The keys. */
            keys: KeyInput;
            /** The recording to come near to. */
            reference?: KeyInput | undefined;
        };
        options: {
            /** The text of the method whose curve it is about. */
            method?: Text | Flag | undefined;
            /** Integral that the tensions make least. */
            objective?: 'linearised' | 'acceleration' | 'torque' | 'jerk' | 'curvature' | 'fit' | undefined;
            /** Inertia of the body that turns, for the objective torque. */
            inertia?: Text | undefined;
            /** Lowest and highest value of every tension. */
            bounds?: Text | undefined;
            /** Tensions to find, such as tension2. */
            free?: Text | undefined;
        };
    };
    /** The fewest keys that reproduce a recording within a tolerance. */
    reduce: {
        inputs: {
            /** The recording, or several; or a skeleton with its clips. */
            recording: KeyInput | SceneInput | (KeyInput | SceneInput)[];
        };
        options: {
            /** The texts of methods, with commas between them. */
            methods?: Text | Flag | undefined;
            /** At most so many at work; 0: one per core. */
            threads?: Text | Flag | undefined;
            /** Smooth the recordings first. */
            smooth?: Text | Flag | undefined;
            /** Of a skeleton: channels that end as they begin have the same tangent at both ends. */
            closed?: Text | Flag | undefined;
            /** Of a skeleton: metres in one unit of length of its file, whose lengths become metres. */
            position_scale?: Text | Flag | undefined;
            /** Rate whose squared integral is kept small. */
            penalty?: 'acceleration' | 'jerk' | undefined;
            /** Standard deviation of the noise of the orientations, per axis. */
            noise?: Text | undefined;
            /** The time within which the correlation of the noise of the orientations falls to 1/e. */
            noise_time?: Text | undefined;
            /** Smoothing time tau; a longer one smooths more. */
            smoothing_time?: Text | undefined;
            /** How much samples far from the curve count: robust rejects outliers, l2 trusts every sample. */
            loss?: 'robust' | 'l2' | 'huber' | 'tukey' | undefined;
            /** Use wx, wy, wz as the rates of a gyro, whose bias is estimated. */
            gyro?: Flag | undefined;
            /** Standard deviation of the noise of the gyro's rates, per axis. */
            gyro_noise?: Text | undefined;
            /** By how much the stamps of the gyro are late. */
            gyro_offset?: Text | undefined;
            /** The bias of the gyro. */
            gyro_bias?: 'constant' | 'drifting' | undefined;
            /** Standard deviation of the noise of the positions, per axis. */
            position_noise?: Text | undefined;
            /** Smooth nothing across intervals longer than this. */
            gap?: Text | undefined;
            /** Let the smoothing time of the orientations vary in time, where that predicts the samples clearly better. */
            adapt?: Flag | undefined;
            /** Of a skeleton: bridge runs of frames in which joints jump away and back while the others go on. */
            runs?: Flag | undefined;
            /** Of a skeleton: joints that stay where they stand on the ground, or auto for those in which its legs end. */
            keep_contacts?: Text | undefined;
            /** Add one standard deviation of every orientation and rate, along the axes of the body. */
            sigma?: Flag | undefined;
            /** Cut-off frequency 1/(2 pi tau) [Hz] instead of the smoothing time: half of a motion at it is left. */
            cutoff?: Text | Flag | undefined;
            /** Largest angle that a joint may be off at any time, in the frame of its parent. */
            tolerance?: Text | undefined;
            /** Largest distance that a joint's translation may be off at any time. */
            position_tolerance?: Text | undefined;
            /** Whether keys stay at samples. */
            values?: 'sampled' | 'refit' | undefined;
            /** Largest distance that points of a skeleton's joints may be off in the world, in its clips. */
            world_tolerance?: Text | undefined;
            /** Distance from a joint of the points that are compared in the world. */
            shell?: Text | undefined;
            /** What the motion of a clip between its keys is taken to be; of BVH, whose frames are samples, smooth unless you say otherwise. */
            between?: 'smooth' | 'stored' | undefined;
            /** How the keys are compressed in the file, where it is glTF. */
            compress?: 'none' | 'meshopt' | undefined;
            /** What the file goes through next, whose faults are kept clear of. */
            for?: 'any' | 'meshopt' | undefined;
            /** Which jumps of joints are cuts, on either side of which nothing swings. */
            cuts?: 'usual' | 'steps' | 'none' | undefined;
            /** Keep tracks of one key that says what the rest pose of the joint says, which are left out otherwise. */
            keep_constant?: Flag | undefined;
        };
    };
    /** The least slowing that keeps a motion within limits. */
    retime: {
        inputs: {
            /** The keys, or a skeleton with its clips. */
            keys: KeyInput | SceneInput;
        };
        options: {
            /** The text of the method whose curve it is about. */
            method?: Text | Flag | undefined;
            /** Largest angular velocity. */
            max_rate?: Text | undefined;
            /** Largest angular acceleration. */
            max_acceleration?: Text | undefined;
            /** Largest angular jerk, the derivative of the angular acceleration. */
            max_jerk?: Text | undefined;
            /** Largest torque on a body of the given inertia. */
            max_torque?: Text | undefined;
            /** Inertia of the body, for the torque. */
            inertia?: Text | undefined;
            /** Largest speed of the position. */
            max_speed?: Text | undefined;
            /** Largest acceleration of the position. */
            max_linear_acceleration?: Text | undefined;
            /** Scale the motion to exactly this duration, from the first key to the last. */
            duration?: Text | undefined;
            /** Which intervals between keys are slowed. */
            slowing?: 'uniform' | 'per-interval' | 'fastest-keys' | undefined;
            /** With the fastest keys: at most so many more keys in each interval, on the curve through yours, where they make the motion faster. */
            insert_keys?: Text | undefined;
            /** Cut rests between equal keys that are longer to this duration. */
            shorten_rests?: Text | undefined;
            /** Go along the same path by this angle each second, through more keys. */
            constant_rate?: Text | undefined;
            /** Go along the same path by this distance of the positions each second, through more keys. */
            constant_speed?: Text | undefined;
            /** Which times of the keys shape the path of an even motion. */
            path_times?: 'lengths' | 'typed' | undefined;
            /** How long such an even motion takes to start and to stop, at the ends and where its path stops. */
            ease?: Text | undefined;
        };
    };
    /** A curve as polynomials that players evaluate. */
    bake: {
        inputs: {
            /** The keys. */
            keys: KeyInput;
        };
        options: {
            /** The text of the method whose curve it is about. */
            method?: Text | Flag | undefined;
            /** Largest angle that is allowed between what is played and the curve. */
            tolerance?: Text | undefined;
            /** Largest distance that is allowed between the positions that are played and the path. */
            position_tolerance?: Text | undefined;
        };
    };
    /** The mean or the median of many orientations. */
    mean: {
        inputs: {
            /** The orientations, with weights where they have the setting weight; several are one set. */
            rows: KeyInput | (KeyInput)[];
        };
        options: {
            /** Which middle: the mean, the median, which bad rows hardly move, or the chordal mean. */
            kind?: 'mean' | 'median' | 'chordal' | undefined;
            /** Length of windows in time, each with a mean of its own. */
            every?: Text | undefined;
        };
    };
    /** What brings one recording onto another one of the same motion. */
    align: {
        inputs: {
            /** The recording that is brought. */
            moved: KeyInput | RateInput;
            /** The one that it is brought onto. */
            fixed: KeyInput | RateInput;
        };
        options: {
            /** Look for the rotation between the axes of the two worlds. */
            world_turn?: Flag | undefined;
            /** Look for the rotation between the axes of the two bodies. */
            body_turn?: Flag | undefined;
            /** By how much the stamps of the moved recording are late, negative where they are early. */
            offset?: Text | undefined;
            /** Look for the scale of the positions. */
            scale?: Flag | undefined;
            /** Look for the translation between the origins of the two worlds. */
            translation?: Flag | undefined;
        };
    };
    /** How near the curves of methods come to a recording. */
    compare: {
        inputs: {
            /** A recording, of which some samples become keys; with a reference the keys themselves. */
            keys: KeyInput;
            /** The recording to compare with. */
            reference?: KeyInput | undefined;
        };
        options: {
            /** The texts of methods, with commas between them. */
            methods?: Text | Flag | undefined;
            /** At most so many at work; 0: one per core. */
            threads?: Text | Flag | undefined;
            /** Methods with tensions once more, tuned. */
            tune?: Text | Flag | undefined;
            /** Bring the keys onto the reference first. */
            align?: Text | Flag | undefined;
            /** The word of the measure to sort by. */
            sort?: Text | Flag | undefined;
            /** Keep every N-th sample as a key. */
            keep_every?: Text | undefined;
            /** How the samples that become keys are spaced. */
            spacing?: 'even' | 'jittered' | 'random' | undefined;
            /** Seed of the random numbers; one seed picks the same samples on every machine. */
            seed?: Text | undefined;
            /** Inertia of the body; with it the torques are measured too. */
            inertia?: Text | undefined;
            /** Estimate the error from the keys alone as well, by leaving some of them out. */
            leave_out?: Flag | undefined;
            /** Tell how many times the least possible energy each curve has. */
            least_energy?: Flag | undefined;
        };
    };
    /** What keys are like, and where the rates of curves through them jump; or what a skeleton's clips hold. */
    inspect: {
        inputs: {
            /** The keys, or a skeleton with its clips. */
            keys: KeyInput | SceneInput;
        };
        options: {
            /** The texts of methods, with commas between them. */
            methods?: Text | Flag | undefined;
        };
    };
    /** How far the motions of a skeleton in two files are apart. */
    difference: {
        inputs: {
            /** A skeleton with its clips. */
            first: SceneInput;
            /** The same skeleton with other clips. */
            second: SceneInput;
        };
        options: {
            /** Look between keys too: at so many times per second, and beside the largest differences [Hz]. */
            rate?: Text | undefined;
            /** At most so many at work; 0: one per core. */
            threads?: Text | Flag | undefined;
            /** Distance from a joint of the points that are compared in the world. */
            shell?: Text | undefined;
        };
    };
    /** Clips of a skeleton cut, turned round, joined, closed into loops, or with the way of a root taken out. */
    clip: {
        inputs: {
            /** A skeleton with its clips, each of which is edited. */
            scene: SceneInput;
            /** The same skeleton with the clip that comes behind. */
            append?: SceneInput | undefined;
        };
        options: {
            /** The name of that clip, where its file has several. */
            append_clip?: Text | Flag | undefined;
            /** The joint whose way a loop keeps, and goes on in the appended clip. */
            root?: Text | Flag | undefined;
            /** The joint whose way across and heading about up go into a node above it. */
            extract_root?: Text | Flag | undefined;
            /** That node, in the place of the topmost one. */
            root_node?: Text | Flag | undefined;
            /** The joint whose way across and heading about up are taken out. */
            in_place?: Text | Flag | undefined;
            /** At most so many at work; 0: one per core. */
            threads?: Text | Flag | undefined;
            /** Keep the clip from this time on. */
            from?: Text | undefined;
            /** Keep the clip up to this time. */
            to?: Text | undefined;
            /** Let it go backwards. */
            reverse?: Flag | undefined;
            /** Let it go so many times as fast. */
            speed?: Text | undefined;
            /** How long the clip goes over into the appended one. */
            blend?: Text | undefined;
            /** Close it, so that it goes on from its end at its start. */
            loop?: Flag | undefined;
            /** With a loop: keep the part of at least this length whose ends are most alike. */
            period_from?: Text | undefined;
            /** With a loop: keep the part of at most this length whose ends are most alike. */
            period_to?: Text | undefined;
            /** The axis of the world that points up. */
            up?: 'y' | 'z' | undefined;
            /** Keys at so many even times per second, and one at the end. */
            rate?: Text | undefined;
            /** Let it start at this time. */
            shift?: Text | undefined;
        };
    };
}
export {};
